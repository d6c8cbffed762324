#include "app/layout.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace pf::app;

namespace {

bool overlap(const Rect& a, const Rect& b) {
  return !a.empty() && !b.empty() && a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

}  // namespace

TEST_CASE("the view has at least 60 % of a window of 1280 x 800") {
  const Layout layout = arrange({});
  CHECK(layout.view.width * layout.view.height >= 0.6f * 1280 * 800);
}

TEST_CASE("the parts tile the window at every size and scale without overlapping") {
  for (const float width : {640.f, 1280.f, 1920.f, 3840.f})
    for (const float height : {400.f, 800.f, 1080.f, 2160.f})
      for (const float em : {11.f, 15.f, 30.f, 45.f})
        for (const bool inspector : {false, true})
          for (const bool drawer : {false, true}) {
            LayoutInput in;
            in.step_strip = drawer;
            in.width = width;
            in.height = height;
            in.em = em;
            in.menu_height = 1.6f * em;
            in.inspector = inspector;
            in.drawer_open = drawer;
            const Layout l = arrange(in);
            CAPTURE(width);
            CAPTURE(height);
            CAPTURE(em);
            const std::array parts{l.menu, l.left, l.view, l.transport, l.inspector, l.drawer};
            float area = 0;
            for (std::size_t i = 0; i < parts.size(); ++i) {
              CHECK(parts[i].x >= 0);
              CHECK(parts[i].right() <= width);
              area += parts[i].width * parts[i].height;
              for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(overlap(parts[i], parts[k]));
            }
            CHECK(l.inspector.empty() == !inspector);
            CHECK((l.step_strip > 0) == in.step_strip);
            if (em > 15 && height < 800) continue;  // the bars alone are higher than such a window
            CHECK(area == doctest::Approx(width * height));
            CHECK(l.view.width >= 0.24f * width);
          }
}

TEST_CASE("hidden panels leave the whole window to the view") {
  LayoutInput in;
  in.hide_panels = in.inspector = in.drawer_open = true;
  const Layout layout = arrange(in);
  CHECK(layout.view == Rect{0, 0, in.width, in.height});
  CHECK(layout.left.empty());
  CHECK(layout.inspector.empty());
}
