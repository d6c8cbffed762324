// The strokes that the overlays are made of: seen on every colour.
#pragma once

#include <string>

#include "app/tools/tool.hpp"
#include "core/charts/painter.hpp"

namespace pf::app {

inline constexpr Color mark_rim{0, 0, 0, 0.55F}, mark_white{1, 1, 1, 0.95F};
inline constexpr Color mark_blue{0.36F, 0.68F, 0.96F, 0.9F}, mark_amber{1, 0.73F, 0.25F, 0.95F};
inline constexpr Color mark_red{1, 0.42F, 0.36F, 0.95F}, mark_green{0.36F, 0.82F, 0.6F, 0.95F};

/// A line with a dark rim, thinner where it is faint.
void mark_line(Painter& painter, Point2 a, Point2 b, Color color, float width);
void mark_arrow(Painter& painter, Point2 from, Point2 to, Color color, float em);
void mark_disc(Painter& painter, Point2 at, float radius, Color color);
/// White text in a dark box beside a point.
void mark_label(Painter& painter, Point2 at, const std::string& text, float em);

}  // namespace pf::app
