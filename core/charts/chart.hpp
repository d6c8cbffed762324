// A chart is data and axes. Nothing here knows pixels: layout.hpp places it, draw.hpp paints it with any Painter.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/charts/colormap.hpp"
#include "core/charts/painter.hpp"

namespace pf {

enum class AxisScale { linear, logarithmic };

/// One axis. On a logarithmic axis values <= 0 have no place: lines break there, ranges ignore them.
struct Axis {
  std::string title = {};  ///< "Total energy"
  std::string unit = {};   ///< SI, "J"; an SI prefix is chosen by the ticks ("kJ"). "" when dimensionless
  AxisScale scale = AxisScale::linear;
  std::optional<double> min = {}, max = {};  ///< the view: zoom, pan, lock. Unset: the data's range, with a margin
  bool include_zero = false;  ///< linear: an unset end is moved to 0 when the data stays on one side of it
  double least_span = 0;      ///< linear: an unset range is at least this wide, so that rounding is not shown as drama
  std::vector<std::pair<double, std::string>> ticks = {};  ///< named places instead of numbers, for categories
};

enum class SeriesStyle { line, points, line_and_points };
enum class MarkShape { circle, square, triangle, diamond, cross };

/// Points in their order. x and y have the same length; a value that is not finite breaks the line.
struct Series {
  std::string label = {};  ///< in the legend; "" leaves it out
  std::vector<double> x = {}, y = {};
  std::vector<double> y_low = {}, y_high = {};  ///< error bars' ends, absolute; empty: none
  std::vector<double> x_low = {}, x_high = {};  ///< the same in x
  SeriesStyle style = SeriesStyle::line;
  std::optional<Color> color = {};              ///< unset: the theme's next
  std::optional<std::size_t> color_index = {};  ///< the theme's colour of this index, the same in every chart
  bool ink = false;                             ///< in the colour of text
  bool dashed = false;
  bool pinned = false;      ///< an earlier run: grey, behind the others
  bool right_axis = false;  ///< belongs to Chart::right
  bool outlined = false;    ///< a rim in the surface's colour: readable over cells of any colour
  MarkShape mark = MarkShape::circle;
};

/// A filled area between two curves over x: a tolerance, a spread.
struct Band {
  std::string label = {};
  std::vector<double> x = {}, low = {}, high = {};
  std::optional<Color> color = {};  ///< unset: the theme's first; its alpha is the fill's
};

/// A line across the plot at a value, with a note at its end.
struct ReferenceLine {
  double at = 0;
  bool vertical = false;  ///< at this x; else at this y
  std::string label = {};
  bool right_axis = false;
};

/// The slope that a theory predicts, drawn as a small triangle. Needs two logarithmic axes.
struct SlopeTriangle {
  double slope = 1;
  std::optional<double> x = {}, y = {};  ///< lower left corner; unset: below the data, right of the middle
  double decades = 0.5;                  ///< width
};

enum class Hatch { none, rising, falling, crossed, dotted, horizontal };

/// A filled rectangle of a heat map or a bar.
struct Cell {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
  Color fill = {};
  Hatch hatch = Hatch::none;
  std::string text = {};  ///< centred, left out where it does not fit
};

/// A legend entry that belongs to no series: what a colour or hatch means.
struct Key {
  std::string label = {};
  Color fill = {};
  Hatch hatch = Hatch::none;
};

/// A colour map's scale at the right side.
struct ColorBar {
  ColormapKind map = ColormapKind::sequential;
  Axis axis = {};  ///< min and max must be set
};

enum class LegendPlace { automatic, none, top_left, top_right, bottom_left, bottom_right, outside_right, above, below };

struct Chart {
  std::string title = {}, subtitle = {};
  Axis x = {}, y = {};
  std::optional<Axis> right = {};  ///< a second vertical axis
  std::vector<Series> series = {};
  std::vector<Band> bands = {};
  std::vector<ReferenceLine> references = {};
  std::vector<SlopeTriangle> triangles = {};
  std::vector<Cell> cells = {};
  std::vector<Key> keys = {};
  std::optional<ColorBar> color_bar = {};
  LegendPlace legend = LegendPlace::automatic;
  bool mark_pareto = false;  ///< ring the points that no other beats in both x and y (less is better), join them
  double pareto_ties = 0;    ///< values that differ by less than this share are ties; so are overlapping error bars
};

/// A series and an index in it.
struct PointId {
  std::size_t series = 0, index = 0;
  bool operator==(const PointId&) const = default;
};

/// The points of left-axis series that are not pinned, for which no other point is as good in x and y and better in
/// one, by rising x. Better means smaller by more than Chart::pareto_ties and beyond both error bars. Places that are
/// not finite (or not positive on a logarithmic axis) do not count.
std::vector<PointId> pareto_front(const Chart& chart);

/// All points as CSV with 17 digits: series,<x>,<y>, and the error bars' ends where a series has them.
std::string chart_csv(const Chart& chart);

}  // namespace pf
