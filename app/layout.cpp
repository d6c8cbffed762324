#include "app/layout.hpp"

#include <algorithm>
#include <cmath>

namespace pf::app {
namespace {

// In em.
constexpr float left_width = 18, inspector_width = 16, wide_width = 21;
constexpr float narrowest_middle = 18;   // beside settings and inspector
constexpr float transport_row = 2.8f;    // a button and the space about it
constexpr float status_row = 2.0f;       // of text, below it where both do not fit in one
constexpr float transport_one_row = 52;  // what one row of it needs
constexpr float drawer_tabs = 2.1f;
constexpr float step_strip_height = 1.9f;
constexpr float time_line_height = 1.2f;

}  // namespace

Layout arrange(const LayoutInput& in) {
  Layout out;
  if (in.hide_panels) {
    out.view = {0, 0, in.width, in.height};
    return out;
  }
  const auto whole = [](float v) { return std::floor(v); };
  out.menu = {0, 0, in.width, in.menu_height};
  const float top = in.menu_height, height = std::max(0.0f, in.height - top);
  // The view keeps at least two fifths of the width however large the text is.
  float left = whole(std::min(left_width * in.em, 0.45f * in.width));
  float right = in.inspector ? whole(std::min(inspector_width * in.em, 0.33f * in.width)) : 0;
  if (in.wide_right) {
    right = whole(std::min(wide_width * in.em, 0.45f * in.width));
    if (in.width - left - right < 0.3f * in.width) left = 0;  // the settings make room for what is being read
  }
  if (right > 0 && in.width - left - right < narrowest_middle * in.em) left = 0;
  const float middle = std::max(0.0f, in.width - left - right);
  out.transport_rows = middle < transport_one_row * in.em ? 2 : 1;
  out.step_strip = in.step_strip ? whole(step_strip_height * in.em) : 0;
  out.time_line = whole(time_line_height * in.em);
  const float transport =
      whole((transport_row + (out.transport_rows == 2 ? status_row : 0)) * in.em) + out.time_line + out.step_strip;
  out.transport_row = transport_row * in.em;
  const float tabs = whole(drawer_tabs * in.em);
  // The drawer leaves the view at least two fifths of the height, where that leaves the drawer room for its tabs.
  const float most = std::max(tabs, std::min(0.5f * height, 0.6f * height - transport));
  const float drawer =
      in.drawer_open ? whole(std::clamp(in.drawer_height * in.em, std::min(tabs + 6 * in.em, most), most)) : tabs;
  out.left = {0, top, left, height};
  out.view = {left, top, middle, std::max(0.0f, height - transport - drawer)};
  out.transport = {left, out.view.bottom(), middle, transport};
  out.drawer = {left, out.transport.bottom(), middle, drawer};
  if (right > 0) out.inspector = {left + middle, top, right, height};
  return out;
}

}  // namespace pf::app
