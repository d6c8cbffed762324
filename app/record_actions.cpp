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

ImageText Workbench::picture_text() const {
  const BuildInfo build = build_info();
  ImageText text{{"Title", context_.scene.name},
                 {"Software", "Pushforward " + std::string(build.version)},
                 {"Commit", std::string(build.commit)},
                 {"Scene hash", scene_hash(context_.scene)}};
  if (context_.snapshot) {
    std::string time;
    append_number(time, context_.snapshot->report.time);
    text.emplace_back("Time", time + " s");
  }
  return text;
}

void Workbench::save_picture(const fs::path& file, const Image& image) {
  try {
    write_png(image, file, picture_text());
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
  if (comparing(context_)) recorder_.stop(context_);
  if (recorder_.follow(context_)) settle_ = std::max(settle_, 2);
  if (std::string trouble = recorder_.take_trouble(); !trouble.empty()) report_file_trouble(trouble);
  const auto frame = recorder_.wanted(context_);
  if (!frame || !view_) return;
  context_.snapshot = frame;
  Image image;
  if (recorder_.whole_window()) {
    hide_mark_ = true;
    draw();
    hide_mark_ = false;
    image = window_.read();
  } else {
    view_->aim(context_);
    image = view_->picture(context_, recorder_.picture());
  }
  recorder_.take(context_, frame, std::move(image), picture_text());
  settle_ = std::max(settle_, 1);
}

}  // namespace pf::app
