// A study of the scene at hand before it is run: proposed, changed by the user, written as a study file. No drawing.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/studies/study.hpp"

namespace pf::app {

struct DraftAxis {
  std::string pointer;
  std::vector<nlohmann::json> values;
  bool operator==(const DraftAxis&) const = default;
};

struct StudyDraft {
  StudyKind kind = StudyKind::work_precision;
  std::vector<DraftAxis> axes;  ///< of a map the first two with several numbers are drawn
  ReferenceKind reference = ReferenceKind::none;
  double fine_step = 0;                   ///< of the fine run [s]
  std::string cost = "wall";              ///< wall | work
  int repeat = 3;                         ///< of each timed run
  double end = 1;                         ///< simulated time of each run [s]
  std::string measure = "energy_change";  ///< column that colours a map
  bool operator==(const StudyDraft&) const = default;
};

/// Every setting of the scene that a study can vary and that can change its motion: pointers, in file order.
std::vector<std::string> variable_settings(const Scene& scene);
/// The axis that is proposed for a setting: what a time step should span depends on the scene's explicit limit.
DraftAxis proposed_axis(const Scene& scene, const std::string& pointer, StudyKind kind);
/// A study that says something about this scene in about a minute, where a step takes `seconds_a_step`.
StudyDraft propose_study(const Scene& scene, StudyKind kind, double seconds_a_step);
/// Against what the draft is measured when nobody has said: the exact motion where there is one.
ReferenceKind usual_reference(const Scene& scene, StudyKind kind);
/// Short enough a step for the reference of these axes [s].
double proposed_fine_step(const Scene& scene, const std::vector<DraftAxis>& axes);
/// Runs from t = 0 to the latest time at which all of the draft's runs take about `budget_s` together, a multiple of
/// five of the longest steps; at most the scene's own end.
double proposed_end(const StudyDraft& draft, const Scene& scene, double seconds_a_step, double budget_s = 60);

struct DraftSize {
  std::size_t runs = 0;  ///< settings
  double steps = 0;      ///< of all runs together, repeats included
};
DraftSize size_of(const StudyDraft& draft, const Scene& scene);
/// Why it cannot be begun as it is; "" when it can.
std::string draft_problem(const StudyDraft& draft, const Scene& scene);
/// The study file, with the scene inside.
std::string study_text(const StudyDraft& draft, const Scene& scene);

}  // namespace pf::app
