// A lesson as it is being read: where the reader is, what was measured, what was answered.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/context.hpp"
#include "app/lessons/lesson.hpp"
#include "app/lessons/measures.hpp"

namespace pf::app {

class LessonDesk {
 public:
  explicit LessonDesk(Lesson lesson) : lesson_(std::move(lesson)) {}

  const Lesson& lesson() const { return lesson_; }
  std::size_t page_index() const { return page_; }
  const LessonPage& page() const { return lesson_.pages[page_]; }
  bool last() const { return page_ + 1 == lesson_.pages.size(); }

  /// Opens a page: scene, values, view. Going back opens it anew.
  void turn_to(AppContext& context, std::size_t page);
  /// Every frame: what the run has come to.
  void follow(AppContext& context);

  bool task_done(const AppContext& context) const;
  /// The condition that the page waits for has come true since it was opened.
  bool seen() const { return seen_ || page().until.empty(); }
  bool taken_apart() const { return taken_apart_ || !page().slow; }
  bool answered() const { return !page().question || answer_ == page().question->answer; }
  bool done(const AppContext& context) const { return task_done(context) && seen() && taken_apart() && answered(); }
  /// Does what the page asks for: sets the values, runs, takes the step apart.
  void help(AppContext& context);

  /// A text of this page with its measured values; as they were when the condition came true, or are now.
  std::string filled(const std::string& text) const;

  std::optional<std::size_t> answer_;  ///< the reader's newest

  bool big = false;  ///< large text, for a projector
  float usual_scale = 1;

 private:
  void see(AppContext& context);
  Constants values(const AppContext& context) const;
  void freeze(const AppContext& context);

  Lesson lesson_;
  std::size_t page_ = 0;
  RunMeasures measures_;
  std::uint64_t run_ = 0;        ///< that is measured
  std::uint64_t stale_run_ = 0;  ///< the one before this page's scene was opened or restarted: does not count
  bool waits_for_run_ = false, seen_ = false, taken_apart_ = false;
  bool run_wanted_ = false;
  Constants kept_, shown_;
};

/// Opens a lesson at its first page, after the user has said what becomes of unsaved changes.
void open_lesson(AppContext& context, Lesson lesson);
void close_lesson(AppContext& context);
void follow_lesson(AppContext& context);
/// The lessons as items of a menu.
void draw_lesson_menu(AppContext& context);

}  // namespace pf::app
