// A lesson is data: pages of text and formulae that set values, wait for what is measured, and ask. It is read from
// assets/lessons, played in the window (desk.hpp) and rehearsed without one (rehearse.hpp).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scene/scene_io.hpp"

namespace pf::app {

/// A paragraph, or a formula on a line of its own. Paragraphs may hold {expression|unit}: a measured value.
struct LessonLine {
  bool formula = false;
  std::string text;
};

struct LessonQuestion {
  std::string text;
  std::vector<std::string> choices, replies;  ///< a reply a choice: why it is right, or what it overlooks
  std::size_t answer = 0;
  std::string because;  ///< a condition that the rehearsal checks: what makes the answer the right one
};

/// What of the view a page changes; unset: stays.
struct LessonView {
  std::string field, plot;
  std::optional<bool> grid, bent_grid, velocities, shapes;
};

struct LessonPage {
  std::string title;
  std::vector<LessonLine> lines;
  std::optional<Scene> scene;  ///< opened when the page comes up
  std::vector<Edit> set;       ///< applied then
  bool restart = false;        ///< begin the run anew then
  std::optional<bool> run;     ///< run or pause then
  LessonView view;
  std::string highlight;   ///< pointer of the setting that the page speaks of
  std::vector<Edit> task;  ///< what the reader is asked to set
  bool slow = false;       ///< the reader is asked to take a step apart
  std::string until, say;  ///< a condition on what is measured, and how it is put to the reader
  double limit = 0;        ///< simulated seconds in which it must come true; 0: the scene's end
  std::vector<std::pair<std::string, std::string>> keep;  ///< values kept for later pages, by name
  std::vector<std::string> holds;                         ///< what the page claims: checked in the rehearsal
  std::optional<LessonQuestion> question;
};

struct Lesson {
  std::filesystem::path file;
  int order = 0, minutes = 5;
  std::string title, about;
  std::vector<LessonPage> pages;
};

/// Throws InputError (every problem, with its pointer) or FileError.
Lesson load_lesson(const std::filesystem::path& file);
Lesson parse_lesson(std::string_view text, const std::string& source);
/// Those that come with the program, in their order; what cannot be read is left out.
std::vector<Lesson> shipped_lessons();

}  // namespace pf::app
