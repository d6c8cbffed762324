// --set and edits: INTERFACE fine print 3.
#include <doctest/doctest.h>

#include "scene_text.hpp"

using namespace pf;
using Json = nlohmann::ordered_json;

namespace {

Scene with(const Json& scene, std::initializer_list<const char*> sets) {
  std::vector<Edit> edits;
  for (const char* set : sets) edits.push_back(parse_set(set));
  return parse_scene(scene.dump(), "test", edits);
}

}  // namespace

TEST_CASE("--set is split at the first = and text that is not JSON is a string") {
  CHECK(parse_set("/time/step=0.5") == Edit{"/time/step", 0.5});
  CHECK(parse_set("/name=a=b") == Edit{"/name", "a=b"});
  CHECK(parse_set("/name=\"5\"") == Edit{"/name", "5"});
  CHECK(parse_set("/name=5") == Edit{"/name", 5});
  CHECK(parse_set("/name=") == Edit{"/name", ""});
  CHECK(parse_set("/gravity=[0, -1]") == Edit{"/gravity", {0, -1}});
  CHECK(parse_set("/time/step=1/60") == Edit{"/time/step", "1/60"});
  CHECK(parse_set("/name=true") == Edit{"/name", true});
  CHECK_THROWS_AS(parse_set("time/step=1"), InputError);
  CHECK_THROWS_AS(parse_set("/time/step"), InputError);
  CHECK_THROWS_AS(parse_set(""), InputError);
  CHECK_THROWS_AS(parse_set("/time={\"step\": 1, \"step\": 2}"), InputError);
  CHECK_THROWS_AS(parse_set("/time/step=1e999"), InputError);
}

TEST_CASE("--set meets the scene with its defaults filled in") {
  CHECK(with(small_scene(), {"/gravity/1=-5"}).gravity == Vec3(0, -5, 0));
  CHECK(with(small_scene(3), {"/gravity/2=-5"}).gravity == Vec3(0, 0, -5));
  CHECK(with(small_scene(), {"/bodies/0/velocity/1=X"}).bodies[0].velocity == FormulaVector{{0, ""}, {0, "X"}});
  CHECK(with(small_scene(), {"/transfer/flip_ratio=0.5"}).transfer.flip_ratio == 0.5);
  CHECK(with(small_scene(), {"/constants/A=2"}).constants.size() == 1);
  CHECK(with(small_scene(), {"/exact/position=[\"X\",\"Y\"]"}).exact_position.size() == 2);
}

TEST_CASE("--set appends with -, replaces by index or whole, in order, and validates only at the end") {
  const char* const probe = "/probes/-={\"name\": \"b\", \"at\": [0, 0]}";
  const Scene two = with(small_scene(), {probe, "/probes/-/name=c", "/probes/1/at=[1, 0]"});
  REQUIRE(two.probes.size() == 2);
  CHECK(two.probes[1].name == "c");
  CHECK(two.probes[1].at == Vec3(1, 0, 0));
  CHECK(with(small_scene(), {"/time/step=1", "/time/step=0.5"}).time.step == 0.5);
  CHECK(with(small_scene(), {"/grid/spacing=-1", "/grid/spacing=0.2"}).grid.spacing == 0.2);
  CHECK(with(full_scene(), {"/events=[]"}).events.empty());
  Json broken = small_scene();
  broken["grid"].erase("spacing");
  CHECK(with(broken, {"/grid/spacing=0.25"}).grid.spacing == 0.25);
}

TEST_CASE("a --set that cannot be is refused with its pointer") {
  for (const char* const set :
       {"/bodies/1/name=b", "/bodies/-1/name=b", "/bodies/00/name=b", "/bodies/x/name=b", "/time/step/a=1",
        "/gravity/2=1", "/nothing=1", "/time/stepp=1", "/a~2b=1", "/dimension=4", "/name=5"}) {
    const Edit edit = parse_set(set);
    const std::vector<Problem> problems = problems_of(small_scene().dump(), {edit});
    CAPTURE(list(problems));
    CHECK_MESSAGE(has_problem(problems, edit.pointer), set);
    for (const Problem& problem : problems) CHECK(problem.line == 0);
  }
}

TEST_CASE("edits of a scene give the scene that they say, or an error and no change") {
  const Scene scene = parse_scene(full_scene().dump(), "test");
  const Edit good[] = {{"/materials/rubber/young", 2e5}, {"/view/color_by", "speed"}};
  const Scene changed = edited(scene, good);
  CHECK(changed.materials[0].parameters[0].second == 2e5);
  CHECK(changed.view.color_by == "speed");
  const Edit bad[] = {{"/materials/rubber/poisson", 0.5}};
  CHECK_THROWS_AS(edited(scene, bad), InputError);
}
