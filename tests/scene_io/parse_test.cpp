#include <doctest/doctest.h>

#include "scene_text.hpp"

using namespace pf;
using Json = nlohmann::ordered_json;

TEST_CASE("a scene's defaults are the contract's") {
  const Scene scene = parse_scene(small_scene().dump(), "test");
  CHECK(scene.dimension == 2);
  CHECK(scene.gravity == Vec3::Zero());
  CHECK(scene.grid.basis == "quadratic");
  CHECK(scene.time.end == 1);
  CHECK(scene.time.step == 0.01);
  CHECK(!scene.time.frame);
  CHECK(scene.time.control == "fixed");
  CHECK(scene.integrator.type == "backward_euler");
  CHECK(scene.integrator.mass == "lumped");
  CHECK(scene.transfer.type == "flip");
  CHECK(scene.transfer.flip_ratio == 0.95);
  CHECK(scene.transfer.velocity_mass == "lumped");
  CHECK(scene.solver.newton_tolerance == 1e-6);
  CHECK(scene.solver.max_newton == 50);
  CHECK(scene.solver.linear == "auto");
  REQUIRE(scene.bodies.size() == 1);
  CHECK(scene.bodies[0].name == "body1");
  CHECK(scene.bodies[0].particles_per_axis == 2);
  CHECK(scene.bodies[0].sampling == "lattice");
  CHECK(scene.bodies[0].velocity == FormulaVector(2));
  CHECK(scene.view.color_by == "speed");
  CHECK_FALSE(scene.view.color_min);
  CHECK_FALSE(scene.view.color_log);
  CHECK(scene.solver.line_search);
}

TEST_CASE("every key of a scene reaches its member") {
  const Scene scene = parse_scene(full_scene().dump(), "test");
  CHECK(scene.constants == std::vector<std::pair<std::string, double>>{{"A", 0.5}, {"c", 2}});
  CHECK(scene.body_force == FormulaVector{{0, "A*sin(X)"}, {0, ""}});
  CHECK(scene.time.frame == 0.02);
  CHECK(scene.integrator.mass == "consistent");
  CHECK(scene.solver.max_newton == 20);
  REQUIRE(scene.materials.size() == 1);
  CHECK(scene.materials[0].name == "rubber");
  CHECK(scene.materials[0].parameters == std::vector<std::pair<std::string, double>>{{"young", 1e5}, {"poisson", 0.3}});
  const Shape& shape = scene.bodies.at(0).shape;
  CHECK(shape.type == "difference");
  CHECK(shape.scale == 2);
  CHECK(shape.rotate_degrees == 30);
  CHECK(shape.translate == Vec3(1, 0, 0));
  REQUIRE(shape.of.size() == 3);
  CHECK(shape.of[0].points == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(shape.of[1].radius == 0.05);
  CHECK(shape.of[2].where == "X*Y - 0.2");
  CHECK(scene.bodies[0].seed == 7);
  CHECK(scene.boundaries.at(0).friction == 0.2);
  CHECK(scene.constraints.at(0).fix == std::vector<bool>{true, false});
  CHECK(scene.loads.at(0).traction[1].text == "-min(t, 1)");
  CHECK(scene.probes.at(0).at == Vec3(1, 1, 0));
  CHECK(scene.events.at(0).set == std::vector<Edit>{{"/transfer/flip_ratio", 0}});
}

TEST_CASE("numbers may be expressions of constants, formulas may be numbers") {
  Json scene = small_scene();
  scene["constants"] = {{"n", 20}};
  scene["grid"]["spacing"] = "1/n";
  scene["gravity"] = {0, "-9.81*2"};
  scene["bodies"][0]["velocity"] = {"n*X", 3};
  const Scene read = parse_scene(scene.dump(), "test");
  CHECK(read.grid.spacing == 0.05);
  CHECK(read.gravity.y() == -19.62);
  CHECK(read.bodies[0].velocity == FormulaVector{{0, "n*X"}, {3, ""}});
  scene["grid"]["spacing"] = "1/0";
  CHECK(has_problem(problems_in(scene), "/grid/spacing"));
  scene["grid"]["spacing"] = "X";
  CHECK(has_problem(problems_in(scene), "/grid/spacing"));
}

TEST_CASE("every problem is told, not just the first, with its line and the nearest known key") {
  const std::vector<Problem> problems = problems_of(R"({
    "dimension": 2,
    "grid": { "spacing": 0, "bais": "linear" },
    "time": { "step": "soon" },
    "materials": { "rubber": { "model": "neo_hookean", "density": -1, "yuong": 1e5, "poisson": 0.5 } },
    "bodies": [ { "material": "ruber", "shape": { "type": "box", "min": [0, 0] } } ],
    "transfer": { "type": "apci" }
  })");
  CAPTURE(list(problems));
  CHECK(problems.size() == 10);
  const std::pair<const char*, int> expected[] = {{"/grid/spacing", 3},
                                                  {"/grid/bais", 3},
                                                  {"/time/step", 4},
                                                  {"/materials/rubber/density", 5},
                                                  {"/materials/rubber/yuong", 5},
                                                  {"/materials/rubber/young", 5},
                                                  {"/materials/rubber/poisson", 5},
                                                  {"/bodies/0/shape/max", 6},
                                                  {"/bodies/0/material", 6},
                                                  {"/transfer/type", 7}};
  for (const auto& [pointer, line] : expected) {
    CAPTURE(pointer);
    bool found = false;
    for (const Problem& problem : problems) {
      if (problem.pointer == pointer) found = problem.line == line;
    }
    CHECK(found);
  }
  const std::string text = list(problems);
  CHECK(text.find("\"young\" (did you mean that?)") != std::string::npos);
  CHECK(text.find("\"apic\" (did you mean that?)") != std::string::npos);
  CHECK(text.find("\"basis\" (did you mean that?)") != std::string::npos);
  CHECK(text.find("kg/m^3") != std::string::npos);
}

TEST_CASE("a scene reads back equal from what is written of it") {
  for (const Json& json : {small_scene(), small_scene(3), full_scene()}) {
    const Scene scene = parse_scene(json.dump(), "test");
    CHECK(parse_scene(scene_text(scene), "text") == scene);
    CHECK(parse_scene(to_json(scene).dump(), "json") == scene);
    CHECK(scene_hash(parse_scene(scene_text(scene), "text")) == scene_hash(scene));
    CHECK(edited(scene, {}) == scene);
  }
}
