// What the Studies drawer remembers: the draft being set up, the study that is open, its charts, and the runner.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/context.hpp"
#include "app/panels/runs.hpp"
#include "app/studies/draft.hpp"
#include "app/studies/library.hpp"
#include "app/studies/runner.hpp"
#include "core/studies/cheapest.hpp"
#include "core/studies/locate.hpp"

namespace pf::app {

struct StudyDesk {
  explicit StudyDesk(AppContext& context);

  /// Once a frame, and whenever the runner has news: takes over results, remakes charts, finds the live scene in them.
  void follow(AppContext& context);
  /// Opens a study file and shows it; earlier results with it.
  void open(StudyFile file);
  /// The draft becomes the study that is open, and begins.
  void start_draft(const Scene& scene);
  /// Back to setting up.
  void set_up(const AppContext& context);
  /// Proposes anew, for this scene.
  void propose(const AppContext& context, StudyKind kind);

  bool timed() const { return results && results->study->cost == "wall"; }
  /// A timed study runs now: the live view stands still.
  bool holds_view() const { return status.stage == StudyStage::running && timed(); }
  const StudyFigure* shown_figure() const;
  const StudyRow* row_of(std::size_t setting) const;
  /// The bound of the question for the cheapest setting [m]; nothing where no error is known.
  std::optional<double> bound() const;
  std::optional<Cheapest> answer() const;

  enum class Page { set_up, results } page = Page::set_up;

  // Setting up.
  StudyDraft draft;
  bool touched = false;               ///< the user changed what was proposed
  Scene drafted_for;                  ///< the scene that the proposal was made for
  std::vector<std::string> variable;  ///< settings of that scene that can be varied
  bool focus_typed = false;           ///< take the keyboard in this frame
  std::string typed_axis, typed;      ///< values that are being typed, and of which setting
  std::string refused_axis, refusal;
  std::vector<LibraryEntry> shipped, earlier;
  bool listed = false;

  // The study that is open.
  StudyStatus status;
  std::shared_ptr<const StudyResults> results;
  std::string identity;  ///< of the study: written into exported charts
  std::vector<StudyFigure> figures;
  std::size_t figure = 0;
  PlotView view;
  bool show_list = false;           ///< in a narrow drawer: what stands beside the chart, instead of it
  std::optional<double> tolerance;  ///< of the question for the cheapest setting [m]; unset: proposed from the errors
  bool located = false;
  Scene located_scene;
  std::optional<StudyPlace> place;  ///< where the live scene is in the study

  StudyRunner runner;  // last: its thread calls the context

 private:
  void forget_study();
  std::shared_ptr<const Study> study_;  ///< that all of the above is about
  std::uint64_t version_ = 0;
  StudyStage stage_ = StudyStage::none;
};

/// The desk of the context, made on the first call.
StudyDesk& studies_of(AppContext& context);

/// Puts a setting of the open study into the live scene, in one undo step.
void load_setting(AppContext& context, std::size_t setting);

}  // namespace pf::app
