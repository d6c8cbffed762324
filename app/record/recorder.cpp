#include "app/record/recorder.hpp"

#include <array>
#include <utility>

#include "app/preferences.hpp"
#include "app/record/film.hpp"
#include "core/files.hpp"
#include "core/output/export.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

namespace {

namespace fs = std::filesystem;

constexpr std::array sizes{PictureFormat{"As the view", {0, 0}}, PictureFormat{"1280 × 720", {1280, 720}},
                           PictureFormat{"1920 × 1080", {1920, 1080}}, PictureFormat{"3840 × 2160", {3840, 2160}}};

}  // namespace

std::span<const PictureFormat> picture_sizes() {
  return sizes;
}

Recorder::~Recorder() = default;

void Recorder::ask(const AppContext& context) {
  open_ = true;
  refusal_.clear();
  have_ffmpeg_ = ffmpeg_present();
  // Names that are free; what the user typed for this scene stays.
  const std::string stem = file_stem(context.scene.name, "scene");
  std::error_code error;
  if (proposed_for_ != stem || fs::exists(choice_.folder, error))
    choice_.folder = free_file(context.save_folder, stem + "-frames", "").string();
  if (proposed_for_ != stem || fs::exists(choice_.file, error))
    choice_.file = free_file(context.save_folder, stem, ".mp4").string();
  if (proposed_for_ != stem) choice_.every.seconds = context.scene.time.frame.value_or(context.scene.time.step);
  proposed_for_ = stem;
}

fs::path Recorder::path() const {
  return choice_.what == RecordChoice::What::film ? with_extension(choice_.file, ".mp4") : fs::path(choice_.folder);
}

bool Recorder::begin(AppContext& context, bool from_start) {
  refusal_.clear();
  RecordOrder order;
  order.every = choice_.by_steps ? FrameSchedule{choice_.every.steps, 0} : choice_.every;
  try {
    if (path().empty()) throw FileError("It needs a name");
    if (choice_.what == RecordChoice::What::files) {
      order.format = &export_formats()[choice_.format];
      order.folder = path();
      make_folder(order.folder);
    } else {
      const bool film = choice_.what == RecordChoice::What::film;
      if (film && !ffmpeg_present()) throw FileError("There is no ffmpeg on this machine");
      writer_ =
          std::make_unique<FrameWriter>(FrameWriter::Target{path(), film, choice_.frames_per_second, context.wake});
    }
  } catch (const FileError& error) {
    refusal_ = error.what();
    return false;
  }
  frames_ = 0;
  taken_step_ = -1;
  on_ = true;
  film_.reset();
  if (comparing(context)) {
    film_.emplace(*context.compare, order.every, from_start);
    return true;
  }
  if (from_start) context.session.reset();
  context.session.record(order);
  context.session.run();
  return true;
}

void Recorder::stop(AppContext& context) {
  if (!std::exchange(on_, false)) return;
  if (!film_) context.session.record(std::nullopt);
  if (writer_) return writer_->finish();
  finish(context);
}

void Recorder::finish(AppContext& context) {
  const long written = writer_ ? writer_->progress().frames : frames_;
  if (trouble_.empty() && context.notify)
    context.notify("Recorded " + std::to_string(written) + (written == 1 ? " frame: " : " frames: ") + path().string());
  else if (!trouble_.empty())
    trouble_ = "The record ended after " + std::to_string(written) + (written == 1 ? " frame. " : " frames. ") +
               trouble_ + "\nThe simulation is not touched by it.";
  writer_.reset();
}

bool Recorder::follow(AppContext& context) {
  if (!busy()) return false;
  const RecordProgress run = context.session.record_progress();
  const bool files = choice_.what == RecordChoice::What::files;
  const bool more = files && run.frames != std::exchange(frames_, files ? run.frames : frames_);
  if (on_ && film_) {
    if (!film_->done() && comparing(context)) return more;
    stop(context);
    return true;
  }
  if (on_) {
    const RunState state = context.status.state;
    const bool at_end = (state == RunState::finished || state == RunState::failed) && run.frames > 0 &&
                        frames_ >= run.frames && !context.session.frame_due();
    if (!run.trouble.empty()) trouble_ = run.trouble;
    if (!run.on || at_end) {
      stop(context);
      return true;
    }
  }
  if (!writer_) return more;
  const FrameWriter::Progress written = writer_->progress();
  if (!written.done) return more;
  trouble_ = written.trouble;
  stop(context);
  finish(context);
  return true;
}

void Recorder::toggle_pause(AppContext& context) {
  if (film_ && comparing(context)) film_->toggle_pause(*context.compare);
}

std::shared_ptr<const ComparisonFrame> Recorder::wanted_lanes(AppContext& context) {
  if (!on_ || !film_ || !writer_ || !writer_->room() || !comparing(context)) return nullptr;
  return film_->due(*context.compare, context.compare->difference ? Field::error : context.view.field);
}

void Recorder::take_lanes(AppContext& context, Image image, ImageText text) {
  writer_->add(std::move(image), std::move(text));
  ++frames_;
  film_->taken(*context.compare);
}

std::shared_ptr<const Snapshot> Recorder::wanted(AppContext& context) const {
  if (!on_ || film_ || !writer_ || !writer_->room()) return nullptr;
  auto frame = context.session.frame_due();
  if (!frame) return nullptr;
  // Published before the window asked for other fields: the same state comes again with them.
  const Field field = context.view.field;
  const std::size_t values = field_info(field).on_nodes ? frame->nodes : frame->particles;
  if (frame->field[static_cast<std::size_t>(field)].size() != values) return nullptr;
  return frame;
}

PictureRequest Recorder::picture() const {
  PictureRequest request;
  request.size = sizes[choice_.size].size;
  request.as_view = choice_.size == 0;
  request.overlay = choice_.show == RecordChoice::Show::view;
  request.transparent = choice_.transparent && choice_.what == RecordChoice::What::images;
  return request;
}

void Recorder::take(AppContext& context, const std::shared_ptr<const Snapshot>& frame, Image image, ImageText text) {
  // A state that came again with other fields has its picture.
  if (frame->report.step != std::exchange(taken_step_, frame->report.step)) {
    writer_->add(std::move(image), std::move(text));
    ++frames_;
  }
  context.session.frame_taken(frame);
}

}  // namespace pf::app
