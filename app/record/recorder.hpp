// Records the run that the window shows, or the lanes of a comparison: pictures, a film, or files of a run's particles.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "app/compare/lane_film.hpp"
#include "app/context.hpp"
#include "app/gl_view.hpp"
#include "app/record/frame_writer.hpp"

namespace pf::app {

/// What the user chose in the dialog.
struct RecordChoice {
  enum class What { images, film, files } what = What::images;
  enum class Show { window, view, plain } show = Show::view;  ///< plain: the view without anything written on it
  bool transparent = false;                                   ///< images that do not show the window
  std::size_t size = 0;                                       ///< into picture_sizes(); not of the window
  bool by_steps = false;
  FrameSchedule every;  ///< both are kept, by_steps says which is meant
  double frames_per_second = 30;
  std::size_t format = 0;    ///< into export_formats()
  std::string folder, file;  ///< of images and files; of the film
};

class Recorder {
 public:
  ~Recorder();
  /// Opens the dialog, with proposals for the scene.
  void ask(const AppContext& context);
  RecordChoice& choice() { return choice_; }
  /// Starts to record as chosen, and the run, from the state at hand or `from_start`. False, and trouble() says why.
  bool begin(AppContext& context, bool from_start);
  /// What was taken until now is kept.
  void stop(AppContext& context);
  bool on() const { return on_; }
  /// On, or pictures are still being written.
  bool busy() const { return on_ || writer_; }
  /// What is recorded are the lanes of a comparison.
  bool of_lanes() const { return film_.has_value(); }
  /// Of lanes, which the record leads: they wait, or go on.
  void toggle_pause(AppContext& context);
  bool paused() const { return film_ && film_->paused(); }

  /// Once a turn: notices the run's end, and what went wrong. True when something new is to be shown.
  bool follow(AppContext& context);
  /// The state whose picture is to be taken now; null: none, or the disc is behind.
  std::shared_ptr<const Snapshot> wanted(AppContext& context) const;
  /// The same of lanes.
  std::shared_ptr<const ComparisonFrame> wanted_lanes(AppContext& context);
  bool whole_window() const { return choice_.show == RecordChoice::Show::window; }
  PictureRequest picture() const;
  void take(AppContext& context, const std::shared_ptr<const Snapshot>& frame, Image image, ImageText text);
  void take_lanes(AppContext& context, Image image, ImageText text);

  /// What went wrong since the last call; empty: nothing.
  std::string take_trouble() { return std::exchange(trouble_, {}); }
  long frames() const { return frames_; }

  /// Inside of ImGui's frame.
  void draw_dialog(AppContext& context);
  /// That a record is being made, and the button that ends it. `hidden`: not in the picture that is being taken.
  void draw_mark(AppContext& context, const Rect& view, bool hidden);

 private:
  void draw_what(bool lanes);
  void draw_picture_choices();
  void draw_schedule(const AppContext& context);
  void draw_target();
  std::filesystem::path path() const;
  void finish(AppContext& context);

  RecordChoice choice_;
  std::string proposed_for_;  ///< the scene that the names were proposed for
  bool open_ = false, have_ffmpeg_ = false, on_ = false;
  std::unique_ptr<FrameWriter> writer_;
  std::optional<LaneFilm> film_;
  long frames_ = 0;       ///< taken, or written by the worker
  long taken_step_ = -1;  ///< of the newest picture
  std::string trouble_, refusal_;
};

/// Sizes of pictures, the first as the view is.
struct PictureFormat {
  const char* label;
  ViewSize size;
};
std::span<const PictureFormat> picture_sizes();

}  // namespace pf::app
