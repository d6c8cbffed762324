// Combinations that cannot work, and shapes that are none.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>

#include "scene_text.hpp"

using namespace pf;
using Json = nlohmann::ordered_json;

namespace {

/// The full scene with one change, and where that must be refused.
void check_refused(const char* pointer, const Json& value, const char* refused_at, Json scene = full_scene()) {
  scene[Json::json_pointer(pointer)] = value;
  const std::vector<Problem> problems = problems_in(scene);
  CHECK_MESSAGE(has_problem(problems, refused_at), pointer << " = " << value.dump() << "\n" << list(problems));
}

Json exact_scene() {
  Json scene = small_scene();
  scene["exact"] = {{"position", {"X + 0.1*sin(t)", "Y"}}};
  return scene;
}

Json box(Json min, Json max) {
  return {{"type", "box"}, {"min", std::move(min)}, {"max", std::move(max)}};
}

}  // namespace

TEST_CASE("names must refer to what there is, once each") {
  check_refused("/bodies/0/material", "steel", "/bodies/0/material");
  check_refused("/loads/0/body", "blok", "/loads/0/body");
  Json scene = full_scene();
  scene["bodies"].push_back(scene["bodies"][0]);
  CHECK(has_problem(problems_in(scene), "/bodies/1/name"));
  scene = full_scene();
  scene["probes"].push_back(scene["probes"][0]);
  CHECK(has_problem(problems_in(scene), "/probes/1/name"));
}

TEST_CASE("combinations that cannot work are refused with the reason") {
  Json scene = full_scene();
  scene["transfer"] = {{"type", "apic"}, {"velocity_mass", "consistent"}};
  CHECK(has_problem(problems_in(scene), "/transfer/velocity_mass"));
  scene.erase("transfer");
  scene["view"] = {{"color_by", "J"}, {"color_min", 0.5}};
  CHECK(has_problem(problems_in(scene), "/view/color_max"));
  scene["view"]["color_max"] = 0.5;
  CHECK(has_problem(problems_in(scene), "/view/color_max"));
  scene["view"]["color_max"] = 2;
  CHECK(problems_in(scene).empty());
  scene["view"]["color_log"] = true;
  CHECK(problems_in(scene).empty());
  scene["view"]["color_min"] = 0;
  CHECK(has_problem(problems_in(scene), "/view/color_min"));
  scene.erase("view");
  scene["transfer"] = {{"type", "apic"}};
  CHECK(problems_in(scene).empty());  // the consistent inertia is allowed
  CHECK(problems_in(exact_scene()).empty());
  check_refused("/bodies/0/velocity", {0, 0}, "/bodies/0/velocity", exact_scene());
  check_refused("/manufactured", true, "/manufactured", small_scene());
  scene = exact_scene();
  scene["manufactured"] = true;
  CHECK(problems_in(scene).empty());
  check_refused("/body_force", {0, 0}, "/body_force", scene);
  check_refused("/time/step", 1e-12, "/time/step");
}

TEST_CASE("a tolerance belongs to adaptive steps, and waits beside fixed ones that are asked for") {
  Json scene = small_scene();
  scene["time"] = {{"tolerance", 1e-3}};
  CHECK(has_problem(problems_in(scene), "/time/tolerance"));
  for (const char* const control : {"adaptive", "fixed"}) {
    scene["time"]["control"] = control;
    const Scene read = parse_scene(scene.dump(), "test");
    CHECK(read.time.tolerance == 1e-3);
    CHECK(parse_scene(scene_text(read), "test") == read);
    // Switched in the window, there and back: an edit like any other.
    const std::vector<Edit> there{{"/time/control", "fixed"}}, back{{"/time/control", "adaptive"}};
    CHECK(edited(edited(read, there), back).time.tolerance == 1e-3);
  }
  scene["time"].erase("tolerance");
  CHECK(!parse_scene(scene.dump(), "test").time.tolerance);
  for (const Json& bad : {Json(0), Json(-1e-3), Json("loose"), Json(true), Json(1e300)}) {
    scene["time"] = {{"control", "adaptive"}, {"tolerance", bad}};
    CHECK_MESSAGE(has_problem(problems_in(scene), "/time/tolerance"), bad.dump());
  }
}

TEST_CASE("a scene with a known motion reads back equal and can be edited") {
  const Scene scene = parse_scene(exact_scene().dump(), "test");
  CHECK(parse_scene(scene_text(scene), "text") == scene);
  CHECK(parse_scene(to_json(scene).dump(), "json") == scene);
  const Edit edits[] = {{"/exact/position", {"X", "Y"}}};
  CHECK(edited(parse_scene(small_scene().dump(), "test"), edits).exact_position.size() == 2);
}

TEST_CASE("the header says what the file is; a newer version is refused as such") {
  check_refused("/format", "pushforward/study", "/format");
  check_refused("/version", 2, "/version");
  check_refused("/version", 0, "/version");
  Json scene = small_scene();
  scene["version"] = 2;
  CHECK(list(problems_in(scene)).find("newer") != std::string::npos);
  for (const char* const key : {"dimension", "grid", "materials", "bodies"}) {
    scene = small_scene();
    scene.erase(key);
    CHECK(has_problem(problems_in(scene), std::string("/") + key));
  }
  for (const char* const text : {"[]", "3", "\"scene\"", "null", "{}"}) CHECK(!problems_of(text).empty());
  check_refused("/bodies", Json::array(), "/bodies");
  check_refused("/materials", Json::object(), "/materials");
}

TEST_CASE("constants have names that expressions can use") {
  for (const char* const name : {"X", "t", "pi", "sin", "max", "", "2a", "a b", "a-b", "\xC3\xA4"}) {
    Json scene = small_scene();
    scene["constants"][name] = 1;
    CHECK_MESSAGE(problems_in(scene).size() == 1, name);
    CHECK(has_problem(problems_in(scene), "/constants/" + std::string(name)));
  }
  check_refused("/constants/B", "1", "/constants/B");
}

TEST_CASE("expressions may use the variables of their place and no other") {
  check_refused("/bodies/0/velocity/0", "t", "/bodies/0/velocity/0");
  check_refused("/bodies/0/velocity/0", "x", "/bodies/0/velocity/0");
  check_refused("/boundaries/0/velocity/0", "X", "/boundaries/0/velocity/0");
  check_refused("/constraints/0/velocity/0", "X", "/constraints/0/velocity/0");
  check_refused("/bodies/0/shape/of/2/expression", "x", "/bodies/0/shape/of/2/expression");
  check_refused("/exact", {{"position", {"x", "Y"}}}, "/exact/position/0", small_scene());
  check_refused("/loads/0/traction/0", "q", "/loads/0/traction/0");
  check_refused("/body_force/0", "sin(", "/body_force/0");
  check_refused("/body_force/0", "", "/body_force/0");
  check_refused("/body_force/0", "1/0", "/body_force/0");
  check_refused("/body_force/0", std::string(100'000, '('), "/body_force/0");
  Json scene = full_scene();
  scene["loads"][0]["traction"] = {"A*X*Y*Z + x*y*z*t", "c"};
  CHECK(problems_in(scene).empty());
}

TEST_CASE("degenerate shapes are refused") {
  const char* const body = "/bodies/0/shape";
  const auto polygon = [](const char* points) { return Json{{"type", "polygon"}, {"points", Json::parse(points)}}; };
  check_refused(body, box({0, 1}, {1, 0}), "/bodies/0/shape/max/1");
  check_refused(body, box({0, 0}, {1, 0}), "/bodies/0/shape/max/1");
  check_refused(body, polygon("[[0,0],[1,1]]"), "/bodies/0/shape/points");
  check_refused(body, polygon("[[0,0],[1,1],[2,2]]"), "/bodies/0/shape/points");
  check_refused(body, polygon("[[0,0],[1,1],[1,0],[0,2]]"), "/bodies/0/shape/points/2");
  check_refused(body, polygon("[[0,0],[1,0],[1,0],[0,1]]"), "/bodies/0/shape/points/1");
  check_refused(body, polygon("[[0,0],[2,0],[2,1],[1,0],[0,1]]"), "/bodies/0/shape/points/3");
  check_refused(body, polygon("[[0,0],[2,0],[1,0],[0,1]]"), "/bodies/0/shape/points/2");
  check_refused(body, Json{{"type", "half_space"}, {"point", {0, 0}}, {"normal", {0, 1}}}, "/bodies/0/shape");
  check_refused(body, Json{{"type", "union"}, {"of", Json::array()}}, "/bodies/0/shape/of");
  check_refused(body, Json{{"type", "cylinder"}, {"from", {0, 0}}, {"to", {0, 1}}, {"radius", 1}},
                "/bodies/0/shape/type");
  check_refused(body, Json{{"type", "ball"}, {"center", {0, 0}}, {"radius", 0}}, "/bodies/0/shape/radius");
  check_refused("/boundaries/0/shape/normal", {0, 0}, "/boundaries/0/shape/normal");
  Json scene = full_scene();
  scene["constraints"][0]["region"] = box({0, 0}, {0, 1});
  CHECK(problems_in(scene).empty());  // a region of zero thickness is legal
  check_refused("/bodies/0/shape", polygon("[[0,0],[1,0],[0,1]]"), "/bodies/0/shape/type", small_scene(3));
}

TEST_CASE("booleans inside booleans end somewhere") {
  Json shape = box({0, 0}, {1, 1});
  for (int k = 0; k < 40; ++k) shape = Json{{"type", "union"}, {"of", Json::array({shape})}};
  Json scene = small_scene();
  scene["bodies"][0]["shape"] = shape;
  const std::vector<Problem> problems = problems_in(scene);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].allowed.find("16 deep") != std::string::npos);
  Json many = Json::array();
  for (int k = 0; k < 600; ++k) many.push_back(box({0, 0}, {1, 1}));
  const Json half = {{"type", "union"}, {"of", many}};
  check_refused("/bodies/0/shape", {{"type", "union"}, {"of", {half, half}}}, "/bodies/0/shape", small_scene());
}

TEST_CASE("events are tried on the scene in the order of their times") {
  const auto event = [](double time, const char* pointer, const Json& value) {
    Json set;
    set[pointer] = value;
    return Json{{"time", time}, {"set", set}};
  };
  check_refused("/events/0", event(1, "/transfer/flip_ratio", 2), "/events/0/set/~1transfer~1flip_ratio");
  check_refused("/events/0", event(1, "/transfer/flip_ration", 1), "/events/0/set/~1transfer~1flip_ration");
  check_refused("/events/0", event(1, "/grid/spacing", 0.1), "/events/0/set/~1grid~1spacing");
  check_refused("/events/0", event(1, "/bodies/-", Json::object()), "/events/0/set/~1bodies~1-");
  check_refused("/events/0", event(1, "gravity", 1), "/events/0/set/gravity");
  Json scene = full_scene();
  scene["events"] = {event(2, "/transfer/velocity_mass", "consistent"), event(1, "/transfer/type", "apic")};
  CHECK(has_problem(problems_in(scene), "/events/0/set/~1transfer~1velocity_mass"));
  scene["events"] = {event(2, "/transfer/velocity_mass", "consistent"), event(1, "/transfer/type", "pic")};
  CHECK(problems_in(scene).empty());
  scene["events"] = {event(0.5, "/gravity/1", -1), event(1, "/materials/rubber/young", 5e4),
                     event(1, "/boundaries/0/friction", 0.1)};
  CHECK_MESSAGE(problems_in(scene).empty(), list(problems_in(scene)));
}

TEST_CASE("huge scenes are refused quickly, and large ones are read quickly") {
  const auto begin = std::chrono::steady_clock::now();
  Json scene = small_scene();
  std::string text = scene.dump();
  const std::string body = scene["bodies"][0].dump();
  std::string bodies = body;
  for (int k = 1; k < 90'000; ++k) bodies += "," + body;
  text.replace(text.find(body), body.size(), bodies);
  CHECK(has_problem(problems_of(text), "/bodies"));
  std::string points = "[";
  for (int k = 0; k < 10'000; ++k) {
    const double angle = k * 6.283185307179586 / 10'000;
    points += (k ? ",[" : "[") + std::to_string(std::cos(angle)) + "," + std::to_string(std::sin(angle)) + "]";
  }
  scene["bodies"][0]["shape"] = {{"type", "polygon"}, {"points", "@"}};
  text = scene.dump();
  text.replace(text.find("\"@\""), 3, points + "]");
  CHECK_MESSAGE(problems_of(text).empty(), list(problems_of(text)));
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
}

TEST_CASE("problems beyond the first hundred are counted") {
  Json scene = full_scene();
  for (int k = 0; k < 1000; ++k) scene["probes"].push_back({{"nam", 1}, {"at", {0, 0}}});
  const std::vector<Problem> problems = problems_in(scene);
  CHECK(problems.size() == 101);
  CHECK(problems.back().found == "900 more problems");
}

TEST_CASE("a stroke of an event is a known kind with a shape; paint has a material of the scene, cut has none") {
  Json scene = small_scene();
  const Json ball = {{"type", "ball"}, {"center", {0, 0}}, {"radius", 0.1}};
  const auto with = [&](const Json& stroke) {
    scene["events"] = Json::array({{{"time", 0.1}, {"strokes", Json::array({stroke})}}});
    return problems_in(scene);
  };
  CHECK(with({{"kind", "cut"}, {"shape", ball}}).empty());
  CHECK(with({{"kind", "paint"}, {"shape", ball}, {"material", scene["bodies"][0]["material"]}}).empty());
  CHECK(has_problem(with({{"kind", "paint"}, {"shape", ball}}), "/events/0/strokes/0/material"));
  CHECK(has_problem(with({{"kind", "paint"}, {"shape", ball}, {"material", "glas"}}), "/events/0/strokes/0/material"));
  CHECK(has_problem(with({{"kind", "cut"}, {"shape", ball}, {"material", scene["bodies"][0]["material"]}}),
                    "/events/0/strokes/0/material"));
  CHECK(has_problem(with({{"kind", "slice"}, {"shape", ball}}), "/events/0/strokes/0/kind"));
  CHECK(has_problem(with({{"kind", "cut"}}), "/events/0/strokes/0/shape"));
  CHECK(has_problem(with({{"kind", "cut"}, {"shape", {{"type", "ball"}, {"radius", -1}}}}),
                    "/events/0/strokes/0/shape/radius"));
  scene["events"] = Json::array({{{"time", 0.1}}});
  CHECK(has_problem(problems_in(scene), "/events/0"));
}
