// Bodies that nothing moves any more.
#include "tests/simulation/scenes.hpp"

using namespace pf;

TEST_CASE("a swing that has died away costs next to nothing: rounding is no reason to go on solving") {
  for (const std::string_view law : {"linear_elastic", "neo_hookean"})
    for (const int dimension : {2, 3}) {
      CAPTURE(law);
      CAPTURE(dimension);
      test::Json scene = test::block(dimension);
      scene["time"]["step"] = 0.05;
      scene["materials"]["rubber"]["model"] = law;
      scene["integrator"]["mass"] = "consistent";
      scene["transfer"] = {{"type", "pic"}, {"velocity_mass", "consistent"}};
      scene["bodies"][0]["velocity"] = dimension == 2 ? test::Json{"0.001*X", 0} : test::Json{"0.001*X", 0, 0};
      const test::Json all = test::box(test::point(dimension, -1, -1, -1), test::point(dimension, 0.2, 2, 2));
      scene["constraints"] = test::Json::array({{{"region", all}, {"fix", std::vector<bool>(dimension, true)}}});
      const auto simulation = test::start(scene);
      simulation->step();
      const double at_first = simulation->report().balance.kinetic;
      int most = 0;
      for (int k = 0; k < 300; ++k) {
        const StepReport& report = simulation->step();
        REQUIRE_MESSAGE(report.status == StepStatus::accepted, report.failure);
        CHECK(report.dt == doctest::Approx(0.05));
        CHECK(report.residual <= simulation->scene().solver.newton_tolerance);
        if (k >= 200) most = std::max(most, static_cast<int>(report.newton.size()) - 1);
      }
      CHECK(simulation->report().balance.kinetic < 1e-14 * at_first);
      CHECK(most <= 5);
    }
}
