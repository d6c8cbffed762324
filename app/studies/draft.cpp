#include "app/studies/draft.hpp"

#include <algorithm>
#include <cmath>

#include "app/panels/limits.hpp"
#include "app/panels/relevance.hpp"
#include "app/studies/describe.hpp"
#include "app/studies/values.hpp"
#include "app/widgets/units.hpp"
#include "core/params/problem.hpp"
#include "core/params/setting.hpp"
#include "core/scene/scene_io.hpp"
#include "core/studies/measure.hpp"

namespace pf::app {

namespace {

using nlohmann::json;

constexpr const char* step_pointer = "/time/step";
constexpr const char* spacing_pointer = "/grid/spacing";
constexpr const char* integrator_pointer = "/integrator/type";
constexpr const char* transfer_pointer = "/transfer/type";

bool is_explicit(const Scene& scene) {
  return scene.integrator.type == "symplectic_euler";
}

/// Settings of the scene that say how it is shown, how long, or where things are: not a method's.
bool beside_the_point(const std::string& pointer) {
  for (const char* prefix : {"/time/end", "/time/frame", "/solver/max_newton", "/view/", "/dimension", "/version",
                             "/format", "/manufactured", "/constants/", "/probes/", "/events/", "/loads/"})
    if (pointer.starts_with(prefix)) return true;
  for (const char* part : {"/shape/", "/region/", "/seed", "/fix/", "/invert"})
    if (pointer.find(part) != std::string::npos) return true;
  return false;
}

json value_in(const Scene& scene, const std::string& pointer) {
  return json(to_json(scene).at(nlohmann::ordered_json::json_pointer(pointer)));
}

std::vector<double> numbers_of(const DraftAxis& axis) {
  std::vector<double> numbers;
  for (const json& value : axis.values)
    if (value.is_number()) numbers.push_back(value.get<double>());
  return numbers;
}

const DraftAxis* find_axis(const std::vector<DraftAxis>& axes, const std::string& pointer) {
  const auto found = std::find_if(axes.begin(), axes.end(), [&](const DraftAxis& a) { return a.pointer == pointer; });
  return found == axes.end() ? nullptr : &*found;
}

/// The least of an axis' numbers; `otherwise` where it is not varied.
double least(const std::vector<DraftAxis>& axes, const std::string& pointer, double otherwise) {
  const DraftAxis* axis = find_axis(axes, pointer);
  if (axis == nullptr) return otherwise;
  const std::vector<double> numbers = numbers_of(*axis);
  return numbers.empty() ? otherwise : *std::min_element(numbers.begin(), numbers.end());
}

std::vector<json> as_json(const std::vector<double>& numbers) {
  return {numbers.begin(), numbers.end()};
}

/// From twice the scene's step down: far enough for explicit steps where they are in reach, by halves where that does.
std::vector<double> falling_steps(const Scene& scene) {
  const double top = is_explicit(scene) ? scene.time.step : 2 * scene.time.step;
  const double limit = explicit_limit(scene).value_or(top);
  double bottom = top / 16;
  if (limit / 2 < bottom && limit > scene.time.step / 200) bottom = limit / 2;
  std::vector<double> steps;
  if (top / bottom <= 40) {
    for (double step = top; step > 0.9 * bottom; step /= 2) steps.push_back(step);
    return steps;
  }
  return ladder(top, bottom, 6, true);
}

/// The map's steps lie on both sides of the explicit limit and of the scene's own step, which is one of them.
std::vector<double> map_steps(const Scene& scene) {
  const double step = scene.time.step, limit = std::max(explicit_limit(scene).value_or(step), step / 100);
  const double low = std::min(step, limit) / 2, high = 4 * std::max(step, limit);
  double ratio = 2;
  while (std::pow(ratio, 8) < high / low) ratio += 1;
  double first = step;
  while (first > 1.2 * low) first /= ratio;
  std::vector<double> steps;
  for (double value = first; value < 1.2 * high; value *= ratio) steps.push_back(rounded(value, 12));
  return steps;
}

/// The motion itself depends on it, so that no single reference serves all of its values.
bool changes_motion(const std::string& pointer) {
  return pointer.starts_with("/materials/") || pointer.starts_with("/boundaries/");
}

bool explicit_in_reach(const Scene& scene) {
  return explicit_limit(scene).value_or(0) > scene.time.step / 200;
}

/// What the map's second axis shows best: the stiffness of the first body's material, else the share of FLIP.
std::string second_axis(const Scene& scene) {
  if (!scene.bodies.empty()) {
    const std::string young = "/materials/" + scene.bodies.front().material + "/young";
    const std::vector<std::string> all = variable_settings(scene);
    if (std::find(all.begin(), all.end(), young) != all.end()) return young;
  }
  return scene.transfer.type == "flip" ? "/transfer/flip_ratio" : spacing_pointer;
}

}  // namespace

std::vector<std::string> variable_settings(const Scene& scene) {
  std::vector<std::string> pointers;
  const nlohmann::ordered_json all = to_json(scene).flatten();
  for (const auto& [pointer, value] : all.items()) {
    const Setting* setting = beside_the_point(pointer) ? nullptr : find_setting(pointer);
    if (setting == nullptr || setting->applies == Applies::view || !scene_uses(scene, pointer)) continue;
    const bool number = setting->kind == SettingKind::number || setting->kind == SettingKind::integer;
    const bool choice = setting->kind == SettingKind::choice && setting->choices.size() > 1;
    if (number || choice || setting->kind == SettingKind::flag) pointers.push_back(pointer);
  }
  return pointers;
}

DraftAxis proposed_axis(const Scene& scene, const std::string& pointer, StudyKind kind) {
  const bool map = kind == StudyKind::stability_map;
  if (pointer == step_pointer) return {pointer, as_json(map ? map_steps(scene) : falling_steps(scene))};
  const Setting* setting = find_setting(pointer);
  const json now = value_in(scene, pointer);
  if (setting == nullptr) return {pointer, {now}};
  if (map && setting->logarithmic && now.is_number() && pointer != spacing_pointer)
    return {pointer,
            as_json(ladder(rounded(now.get<double>() / 100, 3), rounded(now.get<double>() * 100, 3), 5, true))};
  return {pointer, proposed_values(*setting, now)};
}

ReferenceKind usual_reference(const Scene& scene, StudyKind kind) {
  if (kind == StudyKind::stability_map && (conserves_energy(scene) || !scene.manufactured)) return ReferenceKind::none;
  return scene.exact_position.empty() ? ReferenceKind::run : ReferenceKind::exact;
}

double proposed_fine_step(const Scene& scene, const std::vector<DraftAxis>& axes) {
  return rounded(least(axes, step_pointer, scene.time.step) / 4, 12);
}

StudyDraft propose_study(const Scene& scene, StudyKind kind, double seconds_a_step) {
  StudyDraft draft;
  draft.kind = kind;
  draft.reference = usual_reference(scene, kind);
  if (kind == StudyKind::stability_map) {
    draft.cost = "work";
    draft.measure = conserves_energy(scene) ? "energy_change" : "stress_noise";
    draft.axes = {proposed_axis(scene, step_pointer, kind), proposed_axis(scene, second_axis(scene), kind)};
  } else {
    const char* method = explicit_in_reach(scene) ? integrator_pointer : transfer_pointer;
    draft.axes = {proposed_axis(scene, method, kind), proposed_axis(scene, step_pointer, kind)};
  }
  draft.fine_step = proposed_fine_step(scene, draft.axes);
  draft.end = proposed_end(draft, scene, seconds_a_step);
  return draft;
}

double proposed_end(const StudyDraft& draft, const Scene& scene, double seconds_a_step, double budget_s) {
  StudyDraft whole = draft;
  whole.end = scene.time.end;
  double steps = size_of(whole, scene).steps;
  if (draft.reference == ReferenceKind::run) steps += scene.time.end / draft.fine_step;
  double share = budget_s / (steps * std::max(seconds_a_step, 1e-6));
  if (share >= 1) return scene.time.end;
  share = std::pow(2, std::floor(std::log2(share)));  // the same study again though a step took a little longer
  double longest = scene.time.step;
  if (const DraftAxis* axis = find_axis(draft.axes, step_pointer))
    for (const double step : numbers_of(*axis)) longest = std::max(longest, step);
  // So that five times of comparison meet the ends of steps.
  const double unit = 5 * longest;
  return std::min(scene.time.end, rounded(unit * std::max(1.0, std::floor(share * scene.time.end / unit)), 12));
}

DraftSize size_of(const StudyDraft& draft, const Scene& scene) {
  DraftSize size{draft.axes.empty() ? 0u : 1u, 0};
  for (const DraftAxis& axis : draft.axes) size.runs *= axis.values.size();
  if (size.runs == 0) return size;
  const DraftAxis* axis = find_axis(draft.axes, step_pointer);
  const std::vector<double> steps = axis != nullptr ? numbers_of(*axis) : std::vector<double>{scene.time.step};
  double of_each = 0;
  for (const double step : steps) of_each += std::ceil(draft.end / step);
  const double others = static_cast<double>(size.runs) / static_cast<double>(steps.size());
  size.steps = of_each * others * (draft.cost == "wall" ? draft.repeat : 1);
  return size;
}

std::string draft_problem(const StudyDraft& draft, const Scene& scene) {
  if (draft.axes.empty()) return "Nothing is varied yet.";
  for (std::size_t a = 0; a < draft.axes.size(); ++a) {
    if (draft.axes[a].values.empty()) return "A setting has no value to take.";
    for (std::size_t b = 0; b < a; ++b)
      if (draft.axes[a].pointer == draft.axes[b].pointer) return "A setting is varied twice.";
  }
  const auto numbers =
      std::count_if(draft.axes.begin(), draft.axes.end(), [](const DraftAxis& a) { return numbers_of(a).size() > 1; });
  if (draft.kind == StudyKind::stability_map && numbers < 2)
    return "A map needs two settings with several numbers each: one across, one up.";
  if (draft.kind == StudyKind::stability_map && draft.measure.starts_with("energy") && !conserves_energy(scene) &&
      draft.reference == ReferenceKind::none)
    return "Something does work on this scene, so its energy says nothing: colour the map by noise.";
  const bool derived = draft.reference == ReferenceKind::exact && scene.manufactured;
  if (draft.reference != ReferenceKind::none && !derived)
    for (const DraftAxis& axis : draft.axes)
      if (changes_motion(axis.pointer))
        return "One reference cannot serve all values of " + setting_title(scene, axis.pointer) +
               ": they move differently. Measure against nothing (a map), or do not vary it.";
  if (size_of(draft, scene).runs > 10'000) return "More than 10 000 runs: leave out some values.";
  return {};
}

}  // namespace pf::app
