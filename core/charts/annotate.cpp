// Notes inside the plot: names of reference lines, triangles that show a slope.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/charts/placing.hpp"

namespace pf::placing {
namespace {

bool free_of_texts(const Box& box, const ChartLayout& layout) {
  return std::ranges::none_of(layout.texts, [&](const PlacedText& text) { return text.box.overlaps(box); });
}

/// Beside the line, at the place along it and the side where the note hides least, the line's end preferred.
void place_reference(const ReferenceLine& line, const std::vector<Point2>& data, const ChartTheme& theme,
                     const Painter& painter, ChartLayout& layout) {
  if (line.label.empty()) return;
  const AxisMap& map =
      line.vertical ? layout.x.map : (line.right_axis && layout.right ? layout.right->map : layout.y.map);
  const double pixel = map.place(line.at);
  const Box& plot = layout.plot;
  const double low = line.vertical ? plot.min.x : plot.min.y, high = line.vertical ? plot.max.x : plot.max.y;
  if (!(pixel >= low - 0.5 && pixel <= high + 0.5)) return;
  const float at = static_cast<float>(pixel), em = theme.font_size, away = 0.35f * em;
  PlacedText note{.size = 0.92f * em, .role = TextRole::muted};
  note.text = shortened(line.label, 0.5f * plot.width(), note.size, note.weight, painter);
  std::optional<PlacedText> best;
  double least = std::numeric_limits<double>::infinity();
  for (const float along : {1.0f, 0.0f, 0.75f, 0.25f, 0.5f}) {
    for (const bool far_side : {false, true}) {
      const float slack = line.vertical ? plot.height() - 1.5f * em
                                        : plot.width() - 2 * away - painter.text_width(note.text, note.size);
      if (line.vertical) {
        note.align = far_side ? TextAlign::right : TextAlign::left;
        note.at = {far_side ? at - away : at + away, plot.max.y - 0.5f * em - along * slack};
      } else {
        note.at = {plot.min.x + away + along * slack, far_side ? at + away + 0.8f * note.size : at - away};
      }
      const PlacedText placed = placed_text(note, painter);
      if (!plot.contains(placed.box.min) || !plot.contains(placed.box.max) || !free_of_texts(placed.box, layout)) {
        continue;
      }
      const auto hides = [&](Point2 p) { return placed.box.grown(2).contains(p); };
      const double hidden = static_cast<double>(std::ranges::count_if(data, hides));
      if (hidden >= least) continue;
      least = hidden;
      best = placed;
    }
  }
  if (best) layout.texts.push_back(*best);
}

struct TriangleShape {
  Point2 first, second;  ///< ends of the sloped side, left to right
  Point2 corner;         ///< below or above the sloped side, where the data is not
};

/// Height of the drawn data's lower (or upper) edge over [from, to], at its place nearest to the sloped side.
float clearance(const std::vector<Point2>& data, const TriangleShape& shape, bool below) {
  float least = std::numeric_limits<float>::infinity();
  for (const Point2 p : data) {
    if (p.x < shape.first.x - 4 || p.x > shape.second.x + 4) continue;
    const float t = std::clamp((p.x - shape.first.x) / (shape.second.x - shape.first.x), 0.0f, 1.0f);
    const float side = shape.first.y + t * (shape.second.y - shape.first.y);
    least = std::min(least, below ? side - p.y : p.y - side);
  }
  return least;
}

/// Where an unplaced triangle goes: just below the data (above if there is no room), near 0.62 of the width.
bool find_place(const ChartLayout& layout, Point2 size, bool falling, float em, TriangleShape& shape) {
  const std::vector<Point2> data = occupied(layout);
  const Box room = layout.plot.grown(-1.3f * em);
  for (const bool below : {true, false}) {
    for (const float share : {0.62f, 0.5f, 0.74f, 0.38f, 0.84f, 0.26f, 0.14f}) {
      const float x = std::clamp(layout.plot.min.x + share * layout.plot.width() - 0.5f * size.x, room.min.x,
                                 std::max(room.min.x, room.max.x - size.x));
      shape.first = {x, falling ? 0 : size.y};
      shape.second = {x + size.x, falling ? size.y : 0};
      const float least = clearance(data, shape, below);
      if (!std::isfinite(least)) continue;
      const float shift = below ? 1.1f * em - least : least - 1.1f * em;
      shape.first.y += shift;
      shape.second.y += shift;
      const bool corner_left = below == falling;
      shape.corner = {corner_left ? shape.first.x : shape.second.x, corner_left ? shape.second.y : shape.first.y};
      const Box box{{x, std::min(shape.first.y, shape.second.y)},
                    {x + size.x, std::max(shape.first.y, shape.second.y)}};
      const auto taken = [&](const PlacedTriangle& other) {
        const auto [left, right] = std::minmax({other.corners[0].x, other.corners[2].x});
        const auto [top, bottom] = std::minmax({other.corners[0].y, other.corners[2].y});
        return box.grown(1.4f * em).overlaps({{left, top}, {right, bottom}});
      };
      if (room.contains(box.min) && room.contains(box.max) && free_of_texts(box.grown(1.35f * em), layout) &&
          std::ranges::none_of(layout.triangles, taken)) {
        return true;
      }
    }
  }
  return false;
}

void place_triangle(const Chart& chart, const SlopeTriangle& wanted, const ChartTheme& theme, const Painter& painter,
                    ChartLayout& layout) {
  if (chart.x.scale != AxisScale::logarithmic || chart.y.scale != AxisScale::logarithmic || wanted.slope == 0) return;
  const AxisMap &x = layout.x.map, &y = layout.y.map;
  const float em = theme.font_size, ratio = static_cast<float>(std::pow(10, wanted.decades));
  TriangleShape shape{};
  if (wanted.x && wanted.y) {
    const auto point = [&](double vx, double vy) {
      return Point2{static_cast<float>(x.place(vx)), static_cast<float>(y.place(vy))};
    };
    const double rise = std::pow(10, wanted.slope * wanted.decades);
    shape.first = point(*wanted.x, wanted.slope > 0 ? *wanted.y : *wanted.y / rise);
    shape.second = point(*wanted.x * ratio, wanted.slope > 0 ? *wanted.y * rise : *wanted.y);
    shape.corner = wanted.slope > 0 ? Point2{shape.second.x, shape.first.y} : Point2{shape.first.x, shape.second.y};
  } else {
    const double decade_x = (x.to - x.from) * std::log(10) / (std::log(x.max) - std::log(x.min));
    const double decade_y = (y.from - y.to) * std::log(10) / (std::log(y.max) - std::log(y.min));
    const Point2 size{static_cast<float>(wanted.decades * decade_x),
                      static_cast<float>(wanted.decades * std::abs(wanted.slope) * decade_y)};
    if (!find_place(layout, size, wanted.slope < 0, em, shape)) return;
  }
  layout.triangles.push_back({{shape.first, shape.corner, shape.second}});
  const bool corner_left = shape.corner.x == shape.first.x;
  const bool corner_low = shape.corner.y >= std::max(shape.first.y, shape.second.y);
  const auto note = [&](const std::string& text, Point2 at, TextAlign align) {
    layout.texts.push_back(
        placed_text({.at = at, .text = text, .size = 0.92f * em, .role = TextRole::muted, .align = align}, painter));
  };
  const double rounded = std::round(std::abs(wanted.slope) * 100) / 100;
  std::string slope = fixed_text(rounded, rounded == std::round(rounded)             ? 0
                                          : rounded * 10 == std::round(rounded * 10) ? 1
                                                                                     : 2);
  note("1", {0.5f * (shape.first.x + shape.second.x), corner_low ? shape.corner.y + em : shape.corner.y - 0.3f * em},
       TextAlign::centre);
  note(slope,
       {corner_left ? shape.corner.x - 0.35f * em : shape.corner.x + 0.35f * em,
        0.5f * (shape.first.y + shape.second.y) + 0.33f * em},
       corner_left ? TextAlign::right : TextAlign::left);
}

}  // namespace

void place_annotations(const Chart& chart, const ChartTheme& theme, const Painter& painter, ChartLayout& layout) {
  const std::vector<Point2> data = chart.references.empty() ? std::vector<Point2>{} : occupied(layout);
  for (const ReferenceLine& line : chart.references) place_reference(line, data, theme, painter, layout);
  for (const SlopeTriangle& triangle : chart.triangles) place_triangle(chart, triangle, theme, painter, layout);
}

}  // namespace pf::placing
