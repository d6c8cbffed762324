// Nothing overlaps and nothing is cut: every panel, both themes, several scales, at the window's own widths.
#include <doctest/doctest.h>

#include <string>

#include "app/layout.hpp"
#include "app/panels/docks.hpp"
#include "app/panels/memory.hpp"
#include "tests/panels/harness.hpp"

using namespace pf;
using namespace pf::app;

namespace {

/// Tall enough that nothing scrolls: what is scrolled out of sight would count as cut.
constexpr float tall = 6000;

ParticleState made_up_particle() {
  ParticleState p;
  p.id = 4711;
  p.mass = 0.625;
  p.volume0 = 6.25e-4;
  p.X = Vec3(0.2125, 0.5125, 0);
  p.x = Vec3(0.21234, -0.48765, 0);
  p.v = Vec3(-12.345, 0.00123, 0);
  p.F << 1.23456, -0.456789, 0, 0.123456, 0.789012, 0, 0, 0, 1;
  p.sigma << -123456, 4567.8, 0, 4567.8, 89012.3, 0, 0, 0, -34567.8;
  p.energy_density = 12345.6;
  return p;
}

void check(const std::vector<Letter>& found) {
  CHECK(found.size() > 10);
  CHECK(overlaps(found) == "");
  CHECK(cut_off(found) == "");
}

Layout layout_at(float scale, bool inspector) {
  LayoutInput in;
  in.em = base_em * scale;
  in.menu_height = 23 * scale;
  in.inspector = inspector;
  in.drawer_open = true;
  return arrange(in);
}

int count(Dock dock) {
  int n = 0;
  for (const Panel& p : panels()) n += p.dock == dock;
  return n;
}

}  // namespace

TEST_CASE("every left panel shows all of its text without overlap") {
  for (const float scale : {1.0F, 1.5F, 2.0F})
    for (const bool rich : {true, false}) {
      Harness h(rich ? rich_scene() : plain_scene(), rich ? Theme::dark : Theme::light, scale);
      for (int panel = 0; panel < count(Dock::left); ++panel) {
        CAPTURE(scale);
        CAPTURE(rich);
        CAPTURE(panel);
        memory(h.context).open_left = panel;
        h.context.view.show_bent_grid = h.context.view.lock_range = true;
        check(h.settle(ImVec2(layout_at(scale, false).left.width, tall), draw_left_column));
      }
    }
}

TEST_CASE("the inspector shows all of its text without overlap") {
  for (const float scale : {1.0F, 2.0F})
    for (const bool rich : {true, false}) {
      CAPTURE(scale);
      CAPTURE(rich);
      Harness h(rich ? rich_scene() : plain_scene(), Theme::light, scale);
      CHECK_FALSE(has_inspector(h.context));
      h.context.selected_particle = 4711;
      h.context.inspected = made_up_particle();
      CHECK(has_inspector(h.context));
      check(h.settle(ImVec2(layout_at(scale, true).inspector.width, tall), draw_inspector));
    }
}

TEST_CASE("every plot of the drawer shows all of its text without overlap") {
  for (const float scale : {1.0F, 2.0F})
    for (const bool inspector : {false, true})
      for (const Panel& panel : panels()) {
        if (panel.dock != Dock::bottom) continue;
        const std::string plot = panel.title;
        CAPTURE(scale);
        CAPTURE(inspector);
        CAPTURE(plot);
        // As wide as it will be; high enough that the list beside the plot does not scroll.
        const ImVec2 size(layout_at(scale, inspector).drawer.width, 40 * base_em * scale);
        Harness h(rich_scene(), Theme::dark, scale);
        h.frame(size, draw_bottom_drawer);
        memory(h.context).plot = plot;
        memory(h.context).show_plot = true;
        check(h.settle(size, draw_bottom_drawer));
      }
}
