// From a draft to a study file.
#include <algorithm>
#include <cmath>

#include "app/panels/limits.hpp"
#include "app/studies/draft.hpp"
#include "core/params/json_text.hpp"
#include "core/params/problem.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// Five where every run's steps meet all of these times, else the end alone.
int samples_of(const StudyDraft& draft, const Scene& scene) {
  constexpr int wanted = 5;
  if (draft.reference != ReferenceKind::run) return wanted;
  std::vector<double> steps{draft.fine_step, scene.time.step};
  for (const DraftAxis& axis : draft.axes)
    for (const json& value : axis.values)
      if (axis.pointer == "/time/step" && value.is_number()) steps.push_back(value.get<double>());
  const bool meet = std::all_of(steps.begin(), steps.end(), [&](double step) {
    const double count = draft.end / wanted / step;
    return std::abs(count - std::round(count)) < 1e-7 * std::max(1.0, count);
  });
  return meet ? wanted : 1;
}

/// The fine run: short steps, explicit where they are short enough for that, on a grid finer than any.
ordered_json fine_run(const StudyDraft& draft, const Scene& scene) {
  ordered_json edits{{"/time/step", draft.fine_step}};
  Scene finest = scene;
  for (const DraftAxis& axis : draft.axes) {
    if (axis.pointer != "/grid/spacing") continue;
    double least = scene.grid.spacing;
    for (const json& value : axis.values) least = std::min(least, value.get<double>());
    edits["/grid/spacing"] = finest.grid.spacing = least / 2;
  }
  const bool short_enough = draft.fine_step <= 0.5 * explicit_limit(finest).value_or(0);
  if (short_enough && scene.integrator.type != "quasi_static") edits["/integrator/type"] = "symplectic_euler";
  return edits;
}

struct MapAxis {
  std::string pointer;
  double low = 0, high = 0;
};

/// The two axes that the map draws: the first two with several numbers.
std::vector<MapAxis> drawn(const StudyDraft& draft) {
  std::vector<MapAxis> axes;
  for (const DraftAxis& axis : draft.axes) {
    if (axes.size() == 2 || axis.values.size() < 2 || !axis.values.front().is_number()) continue;
    MapAxis found{axis.pointer, axis.values.front().get<double>(), axis.values.front().get<double>()};
    for (const json& value : axis.values) {
      found.low = std::min(found.low, value.get<double>());
      found.high = std::max(found.high, value.get<double>());
    }
    axes.push_back(found);
  }
  return axes;
}

/// The explicit limit dx / c over a map with the time step on an axis: a power of the other axis' value, or none.
ordered_json explicit_line(const StudyDraft& draft, const Scene& scene) {
  const std::vector<MapAxis> axes = drawn(draft);
  if (axes.size() < 2 || (axes[0].pointer == "/time/step") == (axes[1].pointer == "/time/step")) return nullptr;
  const bool step_across = axes[0].pointer == "/time/step";
  const MapAxis& other = axes[step_across ? 1 : 0];
  if (!(other.low > 0)) return nullptr;
  const auto limit_at = [&](double value) {
    try {
      return explicit_limit(edited(scene, std::vector<Edit>{{other.pointer, value}})).value_or(0);
    } catch (const InputError&) {
      return 0.0;
    }
  };
  const double middle = std::sqrt(other.low * other.high);
  const double at_low = limit_at(other.low), at_middle = limit_at(middle), at_high = limit_at(other.high);
  if (!(at_low > 0) || !(at_middle > 0) || !(at_high > 0)) return nullptr;
  const double power = std::log(at_high / at_low) / std::log(other.high / other.low);
  if (std::abs(std::log(at_middle / at_low) - power * std::log(middle / other.low)) > 1e-6) return nullptr;
  const std::string expression = number_text(at_low) + "*(" + (step_across ? "y" : "x") + "/" + number_text(other.low) +
                                 ")^(" + number_text(std::round(1e9 * power) / 1e9) + ")";
  return {{"label", "c dt = dx: explicit steps blow up about here"}, {step_across ? "x" : "y", expression}};
}

}  // namespace

std::string study_text(const StudyDraft& draft, const Scene& scene) {
  const bool map = draft.kind == StudyKind::stability_map;
  const std::string of = scene.name.empty() ? "this scene" : scene.name;
  ordered_json text{{"format", "pushforward/study"},
                    {"version", 1},
                    {"name", (map ? "Stability of " : "Speed against accuracy, ") + of},
                    {"kind", map ? "stability_map" : "work_precision"},
                    {"set", {{"/time/end", draft.end}}},
                    {"vary", ordered_json::object()}};
  for (const DraftAxis& axis : draft.axes) text["vary"][axis.pointer] = axis.values;
  if (draft.reference == ReferenceKind::exact) text["reference"] = "exact";
  if (draft.reference == ReferenceKind::run) text["reference"] = fine_run(draft, scene);
  text["samples"] = samples_of(draft, scene);
  text["cost"] = draft.cost;
  if (draft.cost == "wall") text["repeat"] = draft.repeat;
  text["timeout_s"] = 60;
  if (map) {
    text["measure"] = draft.measure;
    if (const ordered_json limit = explicit_line(draft, scene); !limit.is_null())
      text["limits"] = ordered_json::array({limit});
  }
  text["scene"] = to_json(scene);
  return text.dump(2) + '\n';
}

}  // namespace pf::app
