// Where the parts of the window are: a pure function of its size, so that a test can look for overlaps.
#pragma once

namespace pf::app {

/// In window coordinates, y downwards.
struct Rect {
  float x = 0, y = 0, width = 0, height = 0;
  float right() const { return x + width; }
  float bottom() const { return y + height; }
  bool empty() const { return width <= 0 || height <= 0; }
  bool operator==(const Rect&) const = default;
  bool contains(float px, float py) const { return px >= x && px < right() && py >= y && py < bottom(); }
};

struct LayoutInput {
  float width = 1280, height = 800;
  float em = 15;             ///< height of the interface's text [pixels]
  float menu_height = 23;    ///< as ImGui makes it
  bool hide_panels = false;  ///< nothing but the view
  bool inspector = false;
  bool wide_right = false;  ///< the right column has text and formulae in it
  bool step_strip = false;  ///< a strip of the steps' lengths under the time line
  bool drawer_open = false;
  float drawer_height = 19.5F;  ///< of the open drawer as the user dragged it [em]
};

/// Empty rectangles are not shown.
struct Layout {
  Rect menu, left, view, transport, inspector, drawer;
  int transport_rows = 1;   ///< 2 where one row would be cut
  float transport_row = 0;  ///< height of the first, the buttons' [pixels]
  float time_line = 0;      ///< height of the time line at the transport's upper end [pixels]
  float step_strip = 0;     ///< height of the strip at the transport's lower end [pixels]
  bool operator==(const Layout&) const = default;
};

Layout arrange(const LayoutInput& in);

}  // namespace pf::app
