// A study: one scene, many settings of it, one measured row each (INTERFACE, "Study file").
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.hpp"

namespace pf {

/// One value of an axis: a setting's new value, or several edits under one label.
struct StudyValue {
  std::string label;        ///< of override objects, "" where they have none
  std::vector<Edit> edits;  ///< exactly one on an axis that is a pointer
};

/// One entry of "vary". All combinations of the axes' values are run. An array of override objects is a single axis
/// without a name.
struct StudyAxis {
  std::string key;  ///< "/time/step"; a name of one's own for override objects; "" for the array form
  std::vector<StudyValue> values;
  bool is_pointer() const { return key.starts_with('/'); }
};

enum class StudyKind { work_precision, stability_map };
enum class ReferenceKind { none, exact, run };

/// Where a class begins; written beside the results. Energies are in units of the energy at play (measure.hpp).
struct StudyThresholds {
  double growing = 0.05;  ///< energy gained above this: growing
  double blown_up = 10;   ///< energy gained above this: blown up, and the run is stopped
  double noisy = 0.25;    ///< stress noise above this: noisy
  double damped = 0.1;    ///< energy lost above this: damped
  bool operator==(const StudyThresholds&) const = default;
};

/// One chart of a study. x and y name a column of results.csv, a varied pointer, or "cost".
struct StudyChart {
  std::string name = {};                  ///< of its files; "" for the first: chart.svg, chart.png
  std::string title = {}, subtitle = {};  ///< "" gives one made from the study
  std::string x = "cost", y = "error_l2";
  std::string lines = {};           ///< column that tells lines apart; "" all varied values but the one along a line
  bool fit = false;                 ///< slopes are fitted and stand in the legend
  bool pareto = false;              ///< mark the front
  std::vector<double> slopes = {};  ///< triangles
};

/// A line over a stability map: y as a function of x, or x as one of y, in the axes' units.
struct StudyLimit {
  std::string label;
  std::string y;  ///< expression in x; or
  std::string x;  ///< expression in y
};

/// What a study's numbers must be: with such checks it is a verification case (`pushforward verify`).
struct StudyCheck {
  std::string name;             ///< what is checked, a line of the table
  std::string of = "error_l2";  ///< a column of numbers
  double per = 1;               ///< what it is divided by: an amplitude, a length, a stress
  std::optional<double> exact;  ///< the value is |number - exact| / per
  std::string order_in;         ///< column x: the value is the observed order, d log(of) / d log(x)
  std::string rows = "last";    ///< last: of the last matching row, an order of the last two; all: of each of them
  nlohmann::json where = nlohmann::json::object();  ///< matching rows have these values of varied columns
  std::optional<double> above, below;               ///< bounds of the value
  std::string peer;                                 ///< what the best peer reaches
};

struct Study {
  std::string source;  ///< where it was read from, for messages and titles
  std::string name, about;
  std::string scene_text, scene_source;
  std::vector<Edit> set;  ///< applied to the scene in every run, before the varied values
  StudyKind kind = StudyKind::work_precision;
  std::vector<StudyAxis> axes;
  ReferenceKind reference = ReferenceKind::none;
  std::vector<Edit> reference_edits;  ///< of a fine run, applied after `set`
  std::string cost = "wall";          ///< wall | work
  int repeat = 3;                     ///< timed runs of each setting; 1 where the cost is counted
  double timeout_s = 600;             ///< of one run [s]
  int threads = 1;                    ///< of one run
  int samples = 1;                    ///< times at which a run is compared, evenly spaced, the last one the end
  StudyThresholds thresholds;
  std::string along;                                        ///< column that changes along a line; "" chooses one
  std::string measure;                                      ///< column that colours a map
  std::vector<std::pair<std::string, std::string>> titles;  ///< of columns, for charts: "Time step [s]"
  std::vector<StudyChart> charts;
  std::vector<StudyLimit> limits;
  std::vector<StudyCheck> checks;
  std::string reference_text;  ///< where the exact or trusted answer comes from
  bool quick = false;          ///< takes a second or so: part of every test run
};

/// One setting of a study: which value of each axis, and what that makes of the scene.
struct StudyPoint {
  std::vector<std::size_t> at;  ///< index of the value on each axis
  std::vector<Edit> edits;      ///< Study::set and the values', in order
};

/// How many settings a study has.
std::size_t study_size(const Study& study);
/// The k-th, the last axis running fastest.
StudyPoint study_point(const Study& study, std::size_t k);
/// The k of the setting with these indices of values, one an axis.
std::size_t study_index(const Study& study, std::span<const std::size_t> at);
/// The scene of a setting. Throws InputError where the settings do not go together.
Scene study_scene(const Study& study, const StudyPoint& point);
/// The scene of the fine run that a study is measured against.
Scene reference_scene(const Study& study);
/// The order in which settings are run: as they stand; a stability map from coarse to fine.
std::vector<std::size_t> study_order(const Study& study);

/// What was varied, as columns of a table: an axis of override objects gives its label and each of its pointers.
std::vector<std::string> varied_columns(const Study& study);
/// The value of each such column at a setting: null where the setting leaves it alone.
std::vector<nlohmann::json> varied_values(const Study& study, const StudyPoint& point);

/// Hash of everything that a row depends on: scene, settings, reference, thresholds, program.
std::string study_identity(const Study& study);
/// Names this very program: version, commit, flags, and where the system tells the executable's content.
std::string program_identity();

}  // namespace pf
