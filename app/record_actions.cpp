// Pictures of what is shown, and records of the run: the window's part.
#include <imgui.h>

#include <utility>

#include "app/compare/desk.hpp"
#include "app/preferences.hpp"
#include "app/workbench.hpp"
#include "core/build_info.hpp"
#include "core/files.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {
namespace {

namespace fs = std::filesystem;

/// Frames until a menu has closed: it is no part of the picture of the window.
constexpr int menu_closes = 3;

}  // namespace

bool Workbench::act_on_record(Action action) {
  const std::string stem = file_stem(context_.scene.name, "scene");
  switch (action) {
    case Action::picture:
      picture_ = {free_file(context_.save_folder, stem, ".png"), {}};
      break;
    case Action::picture_bare:
      picture_ = {free_file(context_.save_folder, stem, ".png"), {}};
      picture_.request.overlay = false;
      picture_.request.transparent = true;
      break;
    case Action::picture_window:
      picture_ = {free_file(context_.save_folder, stem + "-window", ".png"), {}, menu_closes};
      break;
    case Action::export_picture:
      ask_picture();
      break;
    case Action::record:
      if (recorder_.on())
        recorder_.stop(context_);
      else if (!recorder_.busy())
        recorder_.ask(context_);
      break;
    default:
      return false;
  }
  settle_ = menu_closes + 1;
  return true;
}

void Workbench::ask_picture() {
  ask_save("Save picture", ".png", context_.save_folder / (file_stem(context_.scene.name, "scene") + ".png"),
           [this](const fs::path& file) {
             picture_ = {file, {}};
             settle_ = 3;
           });
}

ImageText Workbench::picture_text(double time) const {
  const BuildInfo build = build_info();
  ImageText text{{"Title", context_.scene.name},
                 {"Software", "Pushforward " + std::string(build.version)},
                 {"Commit", std::string(build.commit)},
                 {"Scene hash", scene_hash(context_.scene)}};
  std::string seconds;
  append_number(seconds, time);
  text.emplace_back("Time", seconds + " s");
  return text;
}

void Workbench::save_picture(const fs::path& file, const Image& image) {
  try {
    const double time =
        comparing(context_) ? context_.compare->status.time : (context_.snapshot ? context_.snapshot->report.time : 0);
    write_png(image, file, picture_text(time));
    notices_.add("Saved " + file.string());
  } catch (const std::exception& error) {
    report_file_trouble(error.what());
  }
  settle_ = 3;
}

void Workbench::take_view_picture() {
  if (picture_.file.empty() || picture_.window > 0) return;
  const WantedPicture wanted = std::exchange(picture_, {});
  save_picture(wanted.file, view_picture(wanted.request));
}

void Workbench::take_window_picture() {
  if (picture_.window == 0 || --picture_.window > 0) return;
  save_picture(std::exchange(picture_, {}).file, window_.read());
}

void Workbench::record_frame() {
  // What is recorded is one run, or these lanes, from beginning to end.
  if (recorder_.on() && comparing(context_) != recorder_.of_lanes()) recorder_.stop(context_);
  if (recorder_.follow(context_)) settle_ = std::max(settle_, 2);
  if (std::string trouble = recorder_.take_trouble(); !trouble.empty()) report_file_trouble(trouble);
  if (!view_) return;
  if (const auto lanes = recorder_.wanted_lanes(context_)) {
    if (!lane_views_) return;
    recorder_.take_lanes(context_, recorded_picture(), picture_text(lanes->time));
  } else if (const auto frame = recorder_.wanted(context_)) {
    context_.snapshot = frame;
    recorder_.take(context_, frame, recorded_picture(), picture_text(frame->report.time));
  } else {
    return;
  }
  settle_ = std::max(settle_, 1);
}

Image Workbench::recorded_picture() {
  if (!recorder_.whole_window()) {
    view_->aim(context_);
    return view_picture(recorder_.picture());
  }
  hide_mark_ = true;
  draw();
  hide_mark_ = false;
  return window_.read();
}

}  // namespace pf::app
