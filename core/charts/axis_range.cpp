// From data to the values that an axis shows, and between values and pixels.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/charts/placing.hpp"

namespace pf {

double AxisMap::place(double value) const {
  if (scale == AxisScale::linear) return from + (value - min) / (max - min) * (to - from);
  if (!(value > 0)) return std::numeric_limits<double>::quiet_NaN();
  return from + (std::log(value) - std::log(min)) / (std::log(max) - std::log(min)) * (to - from);
}

double AxisMap::value(double pixel) const {
  const double t = (pixel - from) / (to - from);
  if (scale == AxisScale::linear) return min + t * (max - min);
  return std::exp(std::log(min) + t * (std::log(max) - std::log(min)));
}

namespace placing {
namespace {

/// Beyond these, differences and ratios of doubles overflow; charts stop there.
constexpr double largest = 1e300, smallest = 1e-300;

struct Extent {
  AxisScale scale;
  double min = std::numeric_limits<double>::infinity(), max = -min;
  bool empty() const { return min > max; }

  void add(double value) {
    if (!std::isfinite(value) || (scale == AxisScale::logarithmic && value < smallest)) return;
    value = std::clamp(value, -largest, largest);
    min = std::min(min, value);
    max = std::max(max, value);
  }
  void add(std::span<const double> values) {
    for (const double value : values) add(value);
  }
};

const Axis& axis_at(const Chart& chart, Side side) {
  return side == Side::bottom ? chart.x : side == Side::left ? chart.y : *chart.right;
}

Extent data_extent(const Chart& chart, Side side) {
  Extent extent{axis_at(chart, side).scale};
  const bool x = side == Side::bottom;
  for (const Series& series : chart.series) {
    if (!x && (series.right_axis && chart.right.has_value()) != (side == Side::right)) continue;
    extent.add(x ? series.x : series.y);
    extent.add(x ? series.x_low : series.y_low);
    extent.add(x ? series.x_high : series.y_high);
  }
  for (const ReferenceLine& line : chart.references) {
    if (line.vertical == x && (x || line.right_axis == (side == Side::right))) extent.add(line.at);
  }
  if (side == Side::right) return extent;
  for (const Band& band : chart.bands) {
    extent.add(x ? band.x : band.low);
    if (!x) extent.add(band.high);
  }
  for (const Cell& cell : chart.cells) {
    extent.add(x ? cell.x_min : cell.y_min);
    extent.add(x ? cell.x_max : cell.y_max);
  }
  return extent;
}

/// Lines over time begin at the frame; marks and curves in y keep clear of it; cells fill it, but bars do not.
double margin_of(const Chart& chart, Side side) {
  if (!chart.cells.empty()) return axis_at(chart, side).include_zero ? 0.05 : 0;
  const bool marks = std::ranges::any_of(chart.series, [](const Series& s) { return s.style != SeriesStyle::line; });
  return side == Side::bottom && !marks ? 0 : 0.05;
}

Range linear_range(const Axis& axis, const Extent& extent, double margin) {
  double low = extent.min, high = extent.max;
  const double magnitude = std::max(std::abs(low), std::abs(high));
  // Labels tell apart about nine digits; a flat line gets room around it.
  const double least = std::max({axis.least_span, 1e-9 * magnitude, smallest});
  if (high - low < least) {
    const double half = low == high && axis.least_span <= 0 ? (magnitude > 0 ? 0.5 * magnitude : 0.5) : 0.5 * least;
    const double middle = 0.5 * low + 0.5 * high;
    low = middle - half;
    high = middle + half;
  }
  const double room = margin * (high - low);
  const bool zero_low = axis.include_zero && extent.min >= 0, zero_high = axis.include_zero && extent.max <= 0;
  return {zero_low ? 0 : low - room, zero_high && !zero_low ? 0 : high + room};
}

Range logarithmic_range(const Extent& extent, double margin) {
  double low = std::log10(extent.min), high = std::log10(extent.max);
  if (high - low < 1e-6) {
    low -= 0.5;
    high += 0.5;
  }
  const double room = margin * (high - low);
  return {std::pow(10, std::max(low - room, -300.0)), std::pow(10, std::min(high + room, 300.0))};
}

}  // namespace

Range axis_range(const Chart& chart, Side side) {
  const Axis& axis = axis_at(chart, side);
  const Extent extent = data_extent(chart, side);
  const bool logarithmic = axis.scale == AxisScale::logarithmic;
  Range range = logarithmic ? Range{1, 10} : Range{0, 1};
  if (!extent.empty()) {
    const double margin = margin_of(chart, side);
    range = logarithmic ? logarithmic_range(extent, margin) : linear_range(axis, extent, margin);
  }
  const auto usable = [&](const std::optional<double>& end) {
    return end && std::isfinite(*end) && std::abs(*end) <= largest && (!logarithmic || *end >= smallest);
  };
  Range view = range;
  if (usable(axis.min)) view.min = *axis.min;
  if (usable(axis.max)) view.max = *axis.max;
  const double magnitude = std::max(std::abs(view.min), std::abs(view.max));
  const bool wide = logarithmic ? view.max > view.min * (1 + 1e-9) : view.max - view.min > 1e-13 * magnitude;
  if (wide) return view;
  // One end was given and the data lies wholly beyond it: show what follows that end.
  if (usable(axis.min) && !usable(axis.max))
    return {view.min, logarithmic ? view.min * 10 : view.min + std::max(1.0, std::abs(view.min))};
  if (usable(axis.max) && !usable(axis.min))
    return {logarithmic ? view.max / 10 : view.max - std::max(1.0, std::abs(view.max)), view.max};
  return range;
}

}  // namespace placing
}  // namespace pf
