// The legend of the colours. Internal to render/.
#pragma once

#include "render/overlay.hpp"

namespace pf {

/// At the right edge of the rectangle: a bar with ticks and unit, or a list of categories.
void draw_color_bar(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max);

}  // namespace pf
