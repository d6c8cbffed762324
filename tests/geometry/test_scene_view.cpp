#include <doctest/doctest.h>

#include <thread>

#include "core/scene/scene_view.hpp"
#include "shapes_for_tests.hpp"

using namespace pf;
using namespace pf::test;

namespace {

Scene scene_with_regions() {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].name = "rubber";
  scene.bodies.resize(1);
  scene.bodies[0].name = "block";
  scene.constants = {{"R", 2}};
  scene.boundaries.resize(2);
  scene.boundaries[0].shape = half_space({0, 0.5, 0}, {0, 1, 0});
  scene.boundaries[1].shape = where("R^2 - X^2 - Y^2", {-3, -3, 0}, {3, 3, 0});
  scene.boundaries[1].invert = true;
  scene.boundaries[1].contact = "slip";
  scene.constraints.resize(1);
  scene.constraints[0].region = box({-1, 0, 0}, {0, 1, 0});
  scene.loads.resize(1);
  scene.loads[0].region = ball({1, 1, 0}, 0.5);
  return scene;
}

}  // namespace

TEST_CASE("a scene's view knows its boundaries, regions and names") {
  const SceneView view = make_scene_view(scene_with_regions());
  REQUIRE(view.boundaries.size() == 2);
  CHECK(view.boundaries[0].distance({7, 0, 0}) == doctest::Approx(-0.5));
  CHECK(view.boundaries[0].max.y() == 0.5);
  CHECK(view.boundaries[0].contact == "separate");
  // A container is solid outside its shape.
  CHECK(view.boundaries[1].distance({0, 0, 0}) > 0);
  CHECK(view.boundaries[1].distance({0, 2.5, 0}) < 0);
  CHECK(view.boundaries[1].distance({0, 99, 0}) < 0);
  CHECK(view.boundaries[1].contact == "slip");
  REQUIRE(view.regions.size() == 2);
  CHECK(view.regions[0].kind == "constraint");
  CHECK(view.regions[0].distance({-0.5, 0.5, 0}) < 0);
  CHECK(view.regions[1].kind == "load");
  CHECK(view.regions[1].min.isApprox(Vec3(0.5, 0.5, 0)));
  CHECK(view.material_names == std::vector<std::string>{"rubber"});
  CHECK(view.body_names == std::vector<std::string>{"block"});
}

TEST_CASE("a view outlives its scene and answers many threads alike") {
  const auto view = std::make_shared<const SceneView>(make_scene_view(scene_with_regions()));
  const auto sum = [view] {
    double total = 0;
    for (int i = 0; i < 2000; ++i)
      for (const BoundaryView& b : view->boundaries) total += b.distance({0.003 * i, 1 - 0.001 * i, 0});
    return total;
  };
  const double expected = sum();
  std::array<double, 4> totals{};
  {
    std::vector<std::jthread> threads;
    for (double& total : totals) threads.emplace_back([&] { total = sum(); });
  }
  for (const double total : totals) CHECK(total == expected);
}
