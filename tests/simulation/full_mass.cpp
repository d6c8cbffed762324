// The consistent mass at a free edge that is sheared far: with the ghost penalty it holds where it would fail.
#include "tests/simulation/scenes.hpp"

#include "core/assets.hpp"
#include "core/files.hpp"
#include "core/studies/study.hpp"
#include "core/studies/study_io.hpp"

using namespace pf;
using namespace pf::test;

TEST_SUITE("long") {
  TEST_CASE("a full mass holds at free edges with the ghost penalty") {
    // Without it this ends at t = .39 after many retries.
    const Study vortex = load_study(asset_path("verification") / "vortex.json");
    const Scene scene = parse_scene(
        vortex.scene_text, "vortex",
        std::vector<Edit>{{"/grid/basis", "quadratic_gimp"},
                          {"/integrator", {{"type", "tr_bdf2"}, {"mass", "consistent"}, {"ghost_penalty", 0.2}}},
                          {"/transfer", {{"type", "fmpm"}, {"order", 4}}}});
    const auto simulation = make_simulation(scene, {2});
    for (;;) {
      const StepReport& report = simulation->step();
      if (report.status == StepStatus::finished) break;
      REQUIRE_MESSAGE(report.status == StepStatus::accepted, report.failure);
      REQUIRE(report.retries == 0);
    }
    // Lumped APIC leaves .056 of velocity and .094 of F.
    CHECK(simulation->report().error.velocity_l2 < 0.02);
    CHECK(simulation->report().error.F_l2 < 0.09);
  }
}
