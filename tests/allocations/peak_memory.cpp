// What a large scene needs: particles, plan, solve and a snapshot of them.
#include <sys/resource.h>

#include "tests/simulation/scenes.hpp"

using namespace pf;

TEST_SUITE("long") {
  TEST_CASE("a million particles in an implicit step and a snapshot stay below 800 MB") {
    test::Json scene = test::block(3, 0, 1);
    scene["grid"]["spacing"] = 0.02;
    scene["gravity"] = {0, -9.81, 0};
    scene["solver"]["linear"] = "pcg_jacobi";
    scene["constraints"] =
        test::Json::array({{{"region", test::box({-1, -1, -1}, {2, 0, 2})}, {"fix", {true, true, true}}}});
    const auto simulation = test::start(scene);
    REQUIRE(simulation->particle_count() == 1000000);
    Snapshot snapshot;
    SnapshotRequest request;
    request.velocities = true;
    request.fields = 1u << static_cast<unsigned>(Field::von_mises);
    simulation->capture(request, snapshot);
    test::run(*simulation, 2);
    simulation->capture(request, snapshot);
    CHECK(snapshot.particles == simulation->particle_count());
    CHECK(simulation->report().linear_iterations > 0);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double megabytes = static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;  // counted in KiB
    MESSAGE("peak " << megabytes << " MB, of which estimated "
                    << estimated_memory(parse_scene(scene.dump(), "test")) / 1e6);
    CHECK(megabytes < 800);
  }
}
