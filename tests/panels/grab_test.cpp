#include "app/tools/grab.hpp"

#include <doctest/doctest.h>

#include "tests/panels/harness.hpp"

using namespace pf;
using namespace pf::app;

namespace {

/// Remembers what was drawn.
class Recorder final : public Painter {
 public:
  void polyline(std::span<const Point2>, Color, float, float) override { ++lines; }
  void polygon(std::span<const Point2>, Color) override {}
  void rectangle(Point2, Point2, Color, float) override {}
  void circle(Point2, float, Color) override {}
  void ring(Point2, float r, Color, float) override { radius = r; }
  void text(Point2, std::string_view t, float, Color, TextAlign, FontWeight, int) override { said = t; }
  float text_width(std::string_view t, float size, FontWeight) const override {
    return 0.5F * size * static_cast<float>(t.size());
  }
  void push_clip(Point2, Point2) override {}
  void pop_clip() override {}
  int lines = 0;
  float radius = 0;
  std::string said;
};

/// 100 pixels a metre.
class FlatMap final : public ViewMap {
 public:
  std::optional<Point2> to_pixel(const Vec3& p) const override {
    return Point2{static_cast<float>(100 * p.x()), static_cast<float>(-100 * p.y())};
  }
  double metres_per_pixel(const Vec3&) const override { return 0.01; }
  float em() const override { return 15; }
};

struct Bench {
  Bench() : h(rich_scene()), tool(make_grab_tool()) {
    auto s = std::make_shared<Snapshot>();
    s->dimension = 2;
    s->spacing = 0.05;
    s->particles = 2;
    s->id = {41, 42};
    s->x = {0.3, 0.6, 0.5, 0.7};
    s->report.grab_force = 12.5;
    h.context.snapshot = s;
  }
  static ViewMouse mouse(double x, double y, std::optional<std::size_t> particle = {}) {
    ViewMouse m;
    m.pixel = {static_cast<float>(100 * x), static_cast<float>(-100 * y)};
    m.origin = Vec3(x, y, 0);
    m.metres_per_pixel = 0.01;
    m.particle = particle;
    return m;
  }
  Recorder draw(const ViewMouse& m) {
    Recorder r;
    tool->draw(r, FlatMap{}, &m, h.context);
    return r;
  }
  Harness h;
  std::unique_ptr<Tool> tool;
};

}  // namespace

TEST_CASE("the grab takes hold of material only") {
  Bench b;
  CHECK_FALSE(b.tool->press(Bench::mouse(2, 2), b.h.context));
  CHECK(b.tool->press(Bench::mouse(0.5, 0.7, 1), b.h.context));
}

TEST_CASE("a click selects the particle, a click beside the material deselects") {
  Bench b;
  b.tool->click(Bench::mouse(0.5, 0.7, 1), b.h.context);
  CHECK(b.h.context.selected_particle == 42u);
  b.tool->click(Bench::mouse(2, 2), b.h.context);
  CHECK_FALSE(b.h.context.selected_particle);
}

TEST_CASE("a drag shows spring, reach and force; the wheel sets the reach while something is held") {
  Bench b;
  CHECK_FALSE(b.tool->wheel(1, Bench::mouse(0.5, 0.7), b.h.context));  // the camera zooms
  REQUIRE(b.tool->press(Bench::mouse(0.5, 0.7, 1), b.h.context));
  const ViewMouse tremble = Bench::mouse(0.51, 0.7);  // one pixel: still a click
  b.tool->drag(tremble, b.h.context);
  CHECK(b.draw(tremble).lines == 0);
  const ViewMouse away = Bench::mouse(1.0, 1.0);
  b.tool->drag(away, b.h.context);
  const Recorder pulled = b.draw(away);
  CHECK(pulled.lines > 0);
  CHECK(pulled.said == "12.5 N");
  CHECK(b.tool->wheel(2, away, b.h.context));
  CHECK(b.draw(away).radius > pulled.radius);
  b.tool->release(away, b.h.context);
  CHECK(b.draw(away).lines == 0);
}

TEST_CASE("the reach is shown over the body before anything is held, and nowhere else") {
  Bench b;
  CHECK(b.draw(Bench::mouse(0.3, 0.61)).radius > 0);
  CHECK(b.draw(Bench::mouse(2, 2)).radius == 0);
}
