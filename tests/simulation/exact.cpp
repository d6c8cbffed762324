// Problems with exact answers: the error falls at the order that the method has.
#include <numbers>

#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

/// A bar in its lowest mode, held at the left, on rollers; n cells long.
test::Json bar(int n, double step) {
  test::Json scene = test::Json::parse(R"json({
    "dimension": 2, "constants": {"A": 0.01, "w": 15.707963267948966},
    "grid": {"spacing": 1}, "time": {"end": 0.2, "step": 1}, "transfer": {"type": "flip", "flip_ratio": 1},
    "materials": {"bar": {"model": "linear_elastic", "density": 1000, "young": 1e5, "poisson": 0}},
    "bodies": [{"material": "bar", "shape": {"type": "box", "min": [0, 0], "max": [1, 0.0625]}}],
    "constraints": [{"region": {"type": "box", "min": [-1, -1], "max": [0, 2]}, "fix": [true, false]},
                    {"region": {"type": "box", "min": [-1, -1], "max": [2, 2]}, "fix": [false, true]}],
    "exact": {"position": ["X + A*sin(w*t)*sin(pi*X/2)", "Y"]}})json");
  scene["grid"]["spacing"] = 1.0 / n;
  scene["time"]["step"] = step;
  return scene;
}

/// Wallstedt and Guilkey 2008: a square between rollers, stretched along the axes (ANCHORS 2.4); A small: no crossing.
test::Json axis_aligned(int n, double step) {
  test::Json scene = test::Json::parse(R"json({
    "dimension": 2, "constants": {"A": 0.0001, "c": 10},
    "grid": {"spacing": 1}, "time": {"end": 0.06, "step": 1}, "transfer": {"type": "flip", "flip_ratio": 1},
    "solver": {"newton_tolerance": 1e-9},
    "materials": {"m": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
    "bodies": [{"material": "m", "shape": {"type": "box", "min": [0, 0], "max": [1, 1]}}],
    "boundaries": [{"shape": {"type": "box", "min": [0, 0], "max": [1, 1]}, "invert": true, "contact": "slip"}],
    "exact": {"position": ["X + A*sin(2*pi*X)*sin(c*pi*t)", "Y + A*sin(2*pi*Y)*sin(c*pi*t + pi)"]},
    "manufactured": true})json");
  scene["grid"]["spacing"] = 1.0 / n;
  scene["time"]["step"] = step;
  return scene;
}

ErrorNorms final_error(const test::Json& scene) {
  const auto simulation = test::start(scene, 2);
  while (simulation->step().status == StepStatus::accepted) {
  }
  CHECK(simulation->time() == simulation->scene().time.end);
  REQUIRE(simulation->report().error.known);
  return simulation->report().error;
}

/// The largest error of two whole swings.
double worst_error(test::Json scene) {
  scene["time"]["end"] = 0.8;
  const auto simulation = test::start(scene, 2);
  double worst = 0;
  while (simulation->step().status == StepStatus::accepted) worst = std::max(worst, simulation->report().error.l2);
  return worst;
}

/// A block in simple shear that nothing but tractions holds in place, at rest; on rollers below where `rollers`.
double sheared_error(bool rollers) {
  test::Json scene = test::Json::parse(R"json({
    "dimension": 2, "grid": {"spacing": 0.0625}, "time": {"end": 0.2, "step": 0.01}, "transfer": {"type": "pic"},
    "materials": {"m": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
    "bodies": [{"material": "m", "shape": {"type": "box", "min": [0, 0], "max": [1, 1]}}],
    "exact": {"position": ["X + 0.1*Y", "Y"]}, "manufactured": true})json");
  if (rollers)
    scene["constraints"] = test::Json::array({{{"region", test::box({-1, -1}, {2, 0})}, {"fix", {false, true}}}});
  return final_error(scene).l2;
}

}  // namespace

TEST_CASE("a manufactured traction acts in the directions of a held face that are free") {
  const double everywhere = sheared_error(false), on_rollers = sheared_error(true);
  CAPTURE(everywhere);
  CHECK(on_rollers < 2 * everywhere + 1e-6);
}

TEST_CASE("a vibrating bar: at one spacing the error falls with the step, at one step it falls with the spacing") {
  // Backward Euler damps the swing by a part that goes with dt; the walls of the quadratic basis lengthen its period
  // by one that goes with dx.
  const double slow = worst_error(bar(32, 0.008)), step = worst_error(bar(32, 0.004)),
               quick = worst_error(bar(32, 0.002));
  MESSAGE("dt halved twice: " << slow << " " << step << " " << quick);
  CHECK(slow / step > 1.5);
  CHECK(step / quick > 1.6);
  CHECK(step / quick < 2.4);
  const double coarse = worst_error(bar(8, 0.001)), middle = worst_error(bar(16, 0.001)),
               fine = worst_error(bar(32, 0.001));
  MESSAGE("dx halved twice: " << coarse << " " << middle << " " << fine);
  CHECK(coarse / middle > 1.5);
  CHECK(middle / fine > 1.5);
}

TEST_CASE("a vibrating bar: the error halves when spacing and step are halved together") {
  const double coarse = final_error(bar(16, 0.004)).l2, middle = final_error(bar(32, 0.002)).l2,
               fine = final_error(bar(64, 0.001)).l2;
  CHECK(coarse < 0.5 * 0.01);
  CHECK(coarse / middle > 1.6);
  CHECK(middle / fine > 1.7);
  CHECK(middle / fine < 2.6);
}

TEST_CASE("the vibrating bar starts on its exact motion") {
  const auto simulation = test::start(bar(16, 0.004));
  const ErrorNorms error = simulation->report().error;
  CHECK(error.known);
  CHECK(error.l2 == 0);
  CHECK(error.velocity_l2 < 1e-15);
  CHECK(error.F_l2 < 1e-15);
}

TEST_CASE("manufactured loads make the typed motion the solution: a small error on a coarse grid") {
  CHECK(final_error(axis_aligned(16, 0.0005)).l2 < 0.2 * 1e-4);
}

TEST_SUITE("long") {
  TEST_CASE("manufactured solution while no particle crosses a cell: second order with the linear basis") {
    const auto error = [](const char* basis, int n) {
      test::Json scene = axis_aligned(n, 1e-4);
      scene["grid"]["basis"] = basis;
      return final_error(scene).l2;
    };
    const double coarse = error("linear", 8), middle = error("linear", 16), fine = error("linear", 32);
    MESSAGE("linear: errors over A " << coarse / 1e-4 << " " << middle / 1e-4 << " " << fine / 1e-4);
    CHECK(coarse / middle > 3);
    CHECK(middle / fine > 3);
    // Quadratic splines are held at the nodes in and behind the wall, which leaves u(wall) = u_1/8: first order.
    const double wide = error("quadratic", 16), narrow = error("quadratic", 32);
    MESSAGE("quadratic: errors over A " << wide / 1e-4 << " " << narrow / 1e-4);
    CHECK(wide / narrow > 1.8);
  }
}
