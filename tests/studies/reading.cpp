// Study files: what is refused, and where it says so.
#include <doctest/doctest.h>

#include <algorithm>

#include "small_study.hpp"

using namespace pf;
using namespace pf::test;

namespace {

void check_refused(const std::string& members, const std::string& pointer, const std::string& part = "") {
  const std::vector<Problem> problems = study_problems(study_text(members));
  std::string all;
  for (const Problem& problem : problems) all += to_string(problem) + '\n';
  CAPTURE(members);
  CAPTURE(all);
  const auto found =
      std::find_if(problems.begin(), problems.end(), [&](const Problem& p) { return p.pointer == pointer; });
  REQUIRE(found != problems.end());
  CHECK(found->line > 0);
  CHECK_FALSE(found->allowed.empty());
  if (!part.empty()) CHECK((found->found + found->allowed).find(part) != std::string::npos);
}

const std::string vary = R"("vary": {"/time/step": [0.004, 0.002]})";

}  // namespace

TEST_CASE("a study is read with its defaults") {
  const Study study = small_study(vary);
  CHECK(study_size(study) == 2);
  CHECK(study.kind == StudyKind::work_precision);
  CHECK(study.reference == ReferenceKind::exact);  // the scene has one
  CHECK(study.repeat == 3);
  CHECK(study_scene(study, study_point(study, 1)).time.step == 0.002);
}

TEST_CASE("the last axis runs fastest; named axes and lists of override objects are axes too") {
  const Study study = small_study(R"("set": {"/time/end": 0.04}, "vary": {"/time/step": [0.004, 0.002],
    "method": [{"label": "A", "/transfer/type": "apic"}, {"label": "P", "/transfer/type": "pic"}]})");
  CHECK(study_size(study) == 4);
  const Scene scene = study_scene(study, study_point(study, 1));
  CHECK(scene.time.step == 0.004);
  CHECK(scene.time.end == 0.04);
  CHECK(scene.transfer.type == "pic");
  CHECK(varied_columns(study) == std::vector<std::string>{"/time/step", "method", "/transfer/type"});
  const Study list = small_study(
      R"("vary": [{"/time/step": 0.002}, {"/transfer/type": "apic", "/time/step": 0.004}, {"/transfer/type": "pic"}])");
  CHECK(study_size(list) == 3);
  CHECK(varied_columns(list) == std::vector<std::string>{"/time/step", "/transfer/type"});
  CHECK(varied_values(list, study_point(list, 2))[0].is_null());
}

TEST_CASE("wrong studies are refused with pointer, line and what is allowed") {
  check_refused(R"("varry": {})", "/varry", "vary");
  check_refused(R"("repeat": 2)", "/vary", "required");
  check_refused(vary + R"(, "cost": "money")", "/cost", "wall");
  check_refused(vary + R"(, "repeat": 0)", "/repeat");
  check_refused(vary + R"(, "version": 2)", "/version", "newer");
  check_refused(vary + R"(, "reference": 3)", "/reference", "exact");
  check_refused(vary + R"(, "thresholds": {"groing": 1})", "/thresholds/groing", "growing");
  check_refused(vary + R"(, "charts": [{"x": "costs"}])", "/charts/0/x", "cost");
  check_refused(vary + R"(, "kind": "stability_map")", "/vary", "two");
  check_refused(vary + R"(, "set": {"/time/stop": 3})", "/set/~1time~1stop", "step");
  check_refused(R"("vary": {"/time/step": []})", "/vary/~1time~1step");
  check_refused(R"("vary": {"/time/step": [0.1, 0.1]})", "/vary/~1time~1step/1", "once");
  check_refused(R"("vary": {"method": [3]})", "/vary/method/0", "object");
}

TEST_CASE("a value that no run can use is refused where it stands; a bad combination is not") {
  check_refused(R"("vary": {"/time/step": [0.1, -1]})", "/vary/~1time~1step/1", "> 0");
  check_refused(R"("vary": {"/transfer/type": ["flip", "flap"]})", "/vary/~1transfer~1type/1", "flip");
  check_refused(R"("vary": {"/tranfer/type": ["flip", "pic"]})", "/vary/~1tranfer~1type/0", "transfer");
  // APIC does not go with the consistent velocity transfer; each of them is fine with something else.
  const Study study = small_study(
      R"("vary": {"/transfer/type": ["apic", "pic"], "/transfer/velocity_mass": ["lumped", "consistent"]})");
  CHECK(study_size(study) == 4);
  CHECK_THROWS_AS(study_scene(study, study_point(study, 1)), InputError);
}

TEST_CASE("problems of the scene inside a study stand at its place; a missing scene is named") {
  const std::vector<Problem> inside = study_problems(R"({"scene": {"dimension": 2}, "vary": {"/time/step": [1]}})");
  CHECK(std::any_of(inside.begin(), inside.end(), [](const Problem& p) { return p.pointer == "/scene/grid"; }));
  const std::vector<Problem> missing = study_problems(R"({"scene": "nowhere.json", "vary": {"/time/step": [1]}})");
  REQUIRE(missing.size() == 1);
  CHECK(missing[0].pointer == "/scene");
}

TEST_CASE("with a run as reference every time of comparison is the end of a step") {
  const std::string steps = R"("vary": {"/time/step": [0.004, 0.003]}, "reference": {"/time/step": 0.001})";
  CHECK(study_problems(study_text(steps)).empty());
  check_refused(steps + R"(, "samples": 2)", "/samples");
}

TEST_CASE("a map is run from coarse to fine, every setting once") {
  const Study study =
      small_study(R"("kind": "stability_map", "vary": {"/time/step": [0.001, 0.002, 0.003, 0.004, 0.005],
    "/transfer/flip_ratio": [0, 0.25, 0.5, 0.75, 1]})");
  std::vector<std::size_t> order = study_order(study);
  CHECK(std::vector<std::size_t>(order.begin(), order.begin() + 4) == std::vector<std::size_t>{0, 4, 20, 24});
  std::sort(order.begin(), order.end());
  for (std::size_t k = 0; k < 25; ++k) CHECK(order[k] == k);
}
