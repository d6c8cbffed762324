// The legend of the colours. Internal to render/.
#pragma once

#include "render/overlay.hpp"

namespace pf {

/// In a view that is lower than this, a legend would hide what it explains [units].
constexpr float lowest_with_legend = 140;

/// At the right edge of the rectangle: a bar with ticks and unit, or a list of categories.
void draw_color_bar(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max);

}  // namespace pf
