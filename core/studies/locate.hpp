// From a scene to its place in a study, and back: "you are here", and "open this setting".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/studies/study_charts.hpp"

namespace pf {

/// Where a scene lies among a study's settings.
struct StudyPlace {
  std::vector<nlohmann::json> values;          ///< its value of each axis that is a pointer; null on the others
  std::vector<std::optional<std::size_t>> at;  ///< which of the axis' values that is; nothing: it lies between them
  /// The setting that it is; nothing where it is none of them.
  std::optional<std::size_t> setting(const Study& study) const;
};

/// Nothing where the scene differs from the study's in anything that the study does not vary. How long it runs, how
/// often it is drawn, its probes, name and view do not count.
std::optional<StudyPlace> locate(const Study& study, const Scene& scene);

/// A place on a chart, in its axes' values.
struct ChartPlace {
  double x = 0, y = 0;
  bool measured = true;  ///< false: read off between two runs
};
/// Where the place is on this chart: on a map by its values; among lines at the run of its setting, or between the
/// two runs next to it on a line. Nothing where the chart cannot tell.
std::optional<ChartPlace> place_on(const StudyFigure& figure, const Study& study, const StudyPlace& place);

/// A setting of a study, made into a scene to be shown.
struct OpenedSetting {
  Scene scene;
  bool other_scene = false;  ///< `live` was another scene altogether, not other settings of this one
  bool differs = false;      ///< it keeps settings of `live` that the study does not vary and that differ from its own
};
/// The setting put into the live scene; where that cannot be done (it is another scene, or constants are varied, which
/// stand in formulae), the study's own scene. Throws InputError where the settings do not go together.
OpenedSetting open_setting(const Study& study, std::size_t k, const Scene& live);

}  // namespace pf
