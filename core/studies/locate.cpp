#include "core/studies/locate.hpp"

#include <algorithm>
#include <cmath>

#include "core/params/problem.hpp"
#include "core/scene/scene_io.hpp"

namespace pf {

namespace {

using nlohmann::json;

/// What of a scene does not change what is computed at a given time.
Scene bare(Scene scene) {
  scene.name.clear();
  scene.about.clear();
  scene.view = {};
  scene.probes.clear();
  scene.time.end = 1;
  scene.time.frame.reset();
  return scene;
}

bool same_value(const json& a, const json& b) {
  if (!a.is_number() || !b.is_number()) return a == b;
  const double x = a.get<double>(), y = b.get<double>();
  return x == y || std::abs(x - y) <= 1e-12 * std::max(std::abs(x), std::abs(y));
}

/// The value that the scene has of each axis that is a pointer. False where it has none there.
bool read_values(const Study& study, const nlohmann::ordered_json& scene, StudyPlace& place) {
  for (const StudyAxis& axis : study.axes) {
    place.values.emplace_back();
    place.at.emplace_back();
    if (!axis.is_pointer()) continue;
    const nlohmann::ordered_json::json_pointer pointer(axis.key);
    if (!scene.contains(pointer)) return false;
    place.values.back() = json(scene.at(pointer));
    for (std::size_t v = 0; v < axis.values.size(); ++v)
      if (same_value(axis.values[v].edits.front().value, place.values.back())) place.at.back() = v;
  }
  return true;
}

/// Does the scene that the study makes of this place equal `wanted`?
bool agrees(const Study& study, const StudyPlace& place, const Scene& wanted) {
  std::vector<Edit> edits = study.set;
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    const StudyAxis& axis = study.axes[a];
    if (place.at[a]) {
      const std::vector<Edit>& these = axis.values[*place.at[a]].edits;
      edits.insert(edits.end(), these.begin(), these.end());
    } else {
      edits.push_back({axis.key, place.values[a]});
    }
  }
  try {
    return bare(parse_scene(study.scene_text, study.scene_source, edits)) == wanted;
  } catch (const InputError&) {
    return false;
  }
}

/// Tries every combination of the axes that are no pointers.
bool find_overrides(const Study& study, std::size_t axis, const Scene& wanted, StudyPlace& place) {
  if (axis == study.axes.size()) return agrees(study, place, wanted);
  if (study.axes[axis].is_pointer()) return find_overrides(study, axis + 1, wanted, place);
  for (std::size_t v = 0; v < study.axes[axis].values.size(); ++v) {
    place.at[axis] = v;
    if (find_overrides(study, axis + 1, wanted, place)) return true;
  }
  return false;
}

/// The same bodies on the same kind of stage: only settings tell them apart.
bool same_scene(const Scene& a, const Scene& b) {
  const auto alike = [](const auto& these, const auto& those, const auto& equal) {
    return std::equal(these.begin(), these.end(), those.begin(), those.end(), equal);
  };
  return a.dimension == b.dimension &&
         alike(a.bodies, b.bodies,
               [](const Body& x, const Body& y) { return x.shape == y.shape && x.material == y.material; }) &&
         alike(a.materials, b.materials, [](const Material& x, const Material& y) { return x.name == y.name; }) &&
         a.boundaries.size() == b.boundaries.size() && a.constraints.size() == b.constraints.size() &&
         a.loads.size() == b.loads.size();
}

/// The setting's edits without how long a run of the study takes: that is the study's matter.
std::vector<Edit> edits_of(const Study& study, const StudyPoint& point) {
  std::vector<Edit> edits = point.edits;
  const auto end = edits.begin() + static_cast<std::ptrdiff_t>(study.set.size());
  edits.erase(std::remove_if(edits.begin(), end, [](const Edit& e) { return e.pointer == "/time/end"; }), end);
  return edits;
}

struct Neighbour {
  double value, x, y;
};

}  // namespace

std::optional<std::size_t> StudyPlace::setting(const Study& study) const {
  std::vector<std::size_t> indices;
  for (const auto& index : at) {
    if (!index) return std::nullopt;
    indices.push_back(*index);
  }
  return study_index(study, indices);
}

std::optional<StudyPlace> locate(const Study& study, const Scene& scene) {
  StudyPlace place;
  if (!read_values(study, to_json(scene), place) || !find_overrides(study, 0, bare(scene), place)) return std::nullopt;
  return place;
}

namespace {

std::optional<ChartPlace> place_on_map(const StudyFigure& figure, const StudyPlace& place) {
  for (std::size_t a = 0; a < place.at.size(); ++a)
    if (a != figure.x_axis && a != figure.y_axis && place.at[a] != figure.others[a]) return std::nullopt;
  const json &x = place.values[figure.x_axis], &y = place.values[figure.y_axis];
  if (!x.is_number() || !y.is_number()) return std::nullopt;
  return ChartPlace{x.get<double>(), y.get<double>(), true};
}

/// Between two values, on a scale that may be logarithmic.
double between(double low, double high, double t, AxisScale scale) {
  return scale == AxisScale::logarithmic && low > 0 && high > 0 ? low * std::pow(high / low, t)
                                                                : low + t * (high - low);
}

}  // namespace

std::optional<ChartPlace> place_on(const StudyFigure& figure, const Study& study, const StudyPlace& place) {
  if (figure.is_map()) return place_on_map(figure, place);
  const auto open = std::find(place.at.begin(), place.at.end(), std::nullopt);
  if (open != place.at.end() && std::find(open + 1, place.at.end(), std::nullopt) != place.at.end())
    return std::nullopt;
  const auto a = static_cast<std::size_t>(open - place.at.begin());
  if (open != place.at.end() && !place.values[a].is_number()) return std::nullopt;
  for (std::size_t s = 0; s < figure.point.size(); ++s) {
    std::optional<Neighbour> below, above;
    for (std::size_t k = 0; k < figure.point[s].size(); ++k) {
      const std::vector<std::size_t> at = study_point(study, figure.point[s][k]).at;
      bool near = true;
      for (std::size_t b = 0; b < at.size(); ++b) near = near && (b == a || place.at[b] == at[b]);
      if (!near) continue;
      const double x = figure.chart.series[s].x[k], y = figure.chart.series[s].y[k];
      if (open == place.at.end()) return ChartPlace{x, y, true};
      const json& number = study.axes[a].values[at[a]].edits.front().value;
      if (!number.is_number()) continue;
      const double here = place.values[a].get<double>(), value = number.get<double>();
      if (value <= here && (!below || value > below->value)) below = Neighbour{value, x, y};
      if (value >= here && (!above || value < above->value)) above = Neighbour{value, x, y};
    }
    if (!below || !above || below->value == above->value) continue;
    const double here = place.values[a].get<double>();
    const double t = below->value > 0 ? std::log(here / below->value) / std::log(above->value / below->value)
                                      : (here - below->value) / (above->value - below->value);
    return ChartPlace{between(below->x, above->x, t, figure.chart.x.scale),
                      between(below->y, above->y, t, figure.chart.y.scale), false};
  }
  return std::nullopt;
}

OpenedSetting open_setting(const Study& study, std::size_t k, const Scene& live) {
  const StudyPoint point = study_point(study, k);
  OpenedSetting opened{study_scene(study, point), false, false};
  const std::vector<Edit> edits = edits_of(study, point);
  const bool constants =
      std::any_of(edits.begin(), edits.end(), [](const Edit& e) { return e.pointer.starts_with("/constants"); });
  opened.other_scene = !same_scene(opened.scene, live);
  if (!opened.other_scene && !constants) {
    Scene changed = edited(live, edits);
    opened.differs = !(bare(changed) == bare(opened.scene));
    opened.scene = std::move(changed);
  }
  if (!opened.other_scene) opened.scene.view = live.view;
  return opened;
}

}  // namespace pf
