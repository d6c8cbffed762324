// How long an explicit step may be: what the grid's highest frequency predicts against what runs do.
#include <doctest/doctest.h>

#include <sstream>

#include "core/bases/basis.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

/// A bar of 32 x 3 cells on rollers, held at the left, in its lowest mode.
test::Json swinging_bar(std::string_view basis, double step) {
  test::Json scene = test::Json::parse(R"json({
    "dimension": 2, "grid": {"spacing": 0.03125}, "integrator": {"type": "symplectic_euler"}, "transfer": {"type": "apic"},
    "materials": {"m": {"model": "linear_elastic", "density": 1000, "young": 1e5, "poisson": 0}},
    "bodies": [{"material": "m", "shape": {"type": "box", "min": [0, 0], "max": [1, 0.09375]},
                "velocity": ["1e-3*sin(pi*X/2)", 0]}],
    "constraints": [{"region": {"type": "box", "min": [-1, -1], "max": [0, 2]}, "fix": [true, false]},
                    {"region": {"type": "box", "min": [-1, -1], "max": [2, 2]}, "fix": [false, true]}]})json");
  scene["grid"]["basis"] = basis;
  scene["time"] = {{"end", 2000 * step}, {"step", step}};
  return scene;
}

/// Energy after 400 steps over the energy at the start.
double growth(std::string_view basis, double step) {
  const auto simulation = test::start(swinging_bar(basis, step));
  const double before = simulation->report().balance.total();
  for (int k = 0; k < 400; ++k) {
    if (simulation->step().status != StepStatus::accepted) return INFINITY;
    const double now = simulation->report().balance.total();
    if (!(now < 100 * before)) return INFINITY;
  }
  return simulation->report().balance.total() / before;
}

}  // namespace

TEST_CASE("explicit steps are stable up to about nine tenths of the predicted limit, and not at eleven tenths") {
  // The transfer between two steps is not part of the prediction: with quadratic splines runs fail 12 % below it.
  const std::pair<const char*, double> cases[] = {{"linear", 0.9}, {"quadratic", 0.86}, {"cubic", 0.9}};
  for (const auto& [basis, stable] : cases) {
    CAPTURE(std::string(basis));
    const double limit = test::start(swinging_bar(basis, 1e-3))->stable_step();
    CAPTURE(limit / 0.003125);  // in dx/c
    CHECK(growth(basis, stable * limit) < 1.05);
    CHECK(growth(basis, 1.1 * limit) > 10);
  }
}

TEST_CASE("an explicit run that is taken up again tells the same energy, and goes on, to the last bit") {
  const test::Json scene = swinging_bar("quadratic", 1e-3);
  const auto first = test::start(scene), second = test::start(scene);
  test::run(*first, 37);
  std::stringstream state;
  first->save_state(state);
  second->load_state(state);
  for (int k = 0; k < 3; ++k) {
    CHECK(second->report().balance.elastic == first->report().balance.elastic);
    CHECK(second->report().balance.kinetic == first->report().balance.kinetic);
    test::run(*first, 1);
    test::run(*second, 1);
  }
}
