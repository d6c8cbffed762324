// What a study answers: the cheapest setting for an error, where a scene is in it, and a setting as a scene.
#include <doctest/doctest.h>

#include <cmath>

#include "core/scene/scene_io.hpp"
#include "core/studies/cheapest.hpp"
#include "core/studies/driver.hpp"
#include "core/studies/locate.hpp"
#include "small_study.hpp"

using namespace pf;
using namespace pf::test;

namespace {

StudyRow made_up(std::size_t point, double error, double wall, double low, double high) {
  StudyRow row;
  row.point = point;
  row.error_l2 = error;
  row.wall = wall;
  row.wall_min = low;
  row.wall_max = high;
  return row;
}

const std::string grid = R"("vary": {"/integrator/type": ["backward_euler", "symplectic_euler"],
  "/time/step": [0.008, 0.004, 0.002]}, "cost": "work", "samples": 2)";

Scene bar() {
  return parse_scene(bar_scene, "bar");
}

}  // namespace

TEST_CASE("the cheapest setting is the one of least cost below the bound; what the timing cannot tell apart ties") {
  const Study study = small_study(R"("vary": {"/time/step": [0.008, 0.004, 0.002, 0.001, 0.0005]})");
  std::vector<StudyRow> rows{made_up(0, 1e-2, 0.1, 0.09, 0.12), made_up(1, 4e-3, 0.2, 0.19, 0.22),
                             made_up(2, 3e-3, 0.23, 0.21, 0.3), made_up(3, 1e-3, 0.4, 0.39, 0.5),
                             made_up(4, 0, 0.01, 0.01, 0.01)};
  const auto good = cheapest(study, rows, 5e-3);
  REQUIRE(good);
  CHECK(good->best->point == 1);
  REQUIRE(good->ties.size() == 1);  // 0.21 to 0.3 s meets 0.19 to 0.22 s
  CHECK(good->ties[0]->point == 2);
  CHECK(cheapest(study, rows, 1e-2)->best->point == 0);
  CHECK(cheapest(study, rows, 2e-3)->best->point == 3);
  CHECK_FALSE(cheapest(study, rows, 5e-4));  // the run without an error is the reference itself
  rows[1].status = RowStatus::unstable;
  CHECK(cheapest(study, rows, 5e-3)->best->point == 2);
  const auto range = error_range(study, rows);
  REQUIRE(range);
  CHECK(range->first == 1e-3);
  CHECK(range->second == 1e-2);
  CHECK_FALSE(error_range(study, {}));
}

TEST_CASE("a scene is found at the setting that it has, between two settings, or not at all") {
  const Study study = small_study(grid);
  const auto at = [&](std::vector<Edit> edits) { return locate(study, edited(bar(), edits)); };
  const auto here = at({});
  REQUIRE(here);
  CHECK(here->setting(study) == 1u);  // backward Euler, 0.004 s
  const auto other = at({{"/integrator/type", "symplectic_euler"}, {"/time/step", 0.002}, {"/time/end", 7}});
  REQUIRE(other);
  CHECK(other->setting(study) == 5u);
  const auto between = at({{"/time/step", 0.003}});
  REQUIRE(between);
  CHECK_FALSE(between->setting(study));
  CHECK(between->values[1] == 0.003);
  CHECK_FALSE(at({{"/transfer/flip_ratio", 0.5}}));  // the study does not vary it
  CHECK(at({{"/name", "Another name"}, {"/view/color_by", "J"}}));
}

TEST_CASE("a place between two runs lies on the line between their dots") {
  const Study study = small_study(grid);
  StudyDriver driver(study, {});
  REQUIRE(driver.run(1, nullptr));
  const StudyFigure figure = study_figures(study, driver.rows()).front();
  const auto place = [&](double step) {
    return place_on(figure, study, *locate(study, edited(bar(), std::vector<Edit>{{"/time/step", step}})));
  };
  const auto coarse = place(0.008), fine = place(0.004), middle = place(std::sqrt(0.008 * 0.004));
  REQUIRE(coarse);
  REQUIRE(fine);
  REQUIRE(middle);
  CHECK(coarse->measured);
  CHECK_FALSE(middle->measured);
  CHECK(coarse->x == driver.rows()[0].work);
  CHECK(coarse->y == driver.rows()[0].error_l2);
  CHECK(middle->x == doctest::Approx(std::sqrt(coarse->x * fine->x)));
  CHECK(middle->y == doctest::Approx(std::sqrt(coarse->y * fine->y)));
  CHECK_FALSE(place(0.1));  // beyond the runs
}

TEST_CASE("on a map a scene lies at its own two values, on the map of its other settings") {
  const Study study = small_study(R"("kind": "stability_map", "vary": {"/time/step": [0.004, 0.002],
    "/materials/bar/young": [1e4, 1e5, 1e6], "/integrator/type": ["backward_euler", "symplectic_euler"]},
    "cost": "work")");
  StudyDriver driver(study, {});
  REQUIRE(driver.run(1, nullptr));
  const std::vector<StudyFigure> figures = study_figures(study, driver.rows());
  REQUIRE(figures.size() == 2);
  const auto here = locate(study, edited(bar(), std::vector<Edit>{{"/time/step", 0.003}}));
  REQUIRE(here);
  const auto place = place_on(figures[0], study, *here);
  REQUIRE(place);
  CHECK(place->x == 0.003);
  CHECK(place->y == 1e5);
  CHECK_FALSE(place_on(figures[1], study, *here));
}

TEST_CASE("a setting opens in the live scene and leaves what the study does not vary, its length too") {
  const Study study = small_study(grid + R"(, "set": {"/time/end": 0.04})");
  const Scene live = edited(bar(), std::vector<Edit>{{"/time/end", 3}, {"/view/color_by", "J"}});
  const OpenedSetting opened = open_setting(study, 5, live);
  CHECK_FALSE(opened.other_scene);
  CHECK_FALSE(opened.differs);
  CHECK(opened.scene.integrator.type == "symplectic_euler");
  CHECK(opened.scene.time.step == 0.002);
  CHECK(opened.scene.time.end == 3);
  CHECK(opened.scene.view.color_by == "J");
  CHECK(locate(study, opened.scene)->setting(study) == 5u);
  const Scene heavier = edited(live, std::vector<Edit>{{"/materials/bar/density", 3000}});
  CHECK(open_setting(study, 5, heavier).differs);
  CHECK(open_setting(study, 5, heavier).scene.materials[0].density == 3000);
}

TEST_CASE("where constants are varied, or another scene is open, a setting opens as the study's own scene") {
  const Study study = small_study(R"("vary": {"/constants/A": [0.01, 0.02]}, "cost": "work")");
  const OpenedSetting same = open_setting(study, 1, bar());
  CHECK_FALSE(same.other_scene);
  CHECK(same.scene.constants[0].second == 0.02);
  CHECK(locate(study, same.scene)->setting(study) == 1u);
  Scene other = bar();
  other.bodies[0].shape.max.x() = 2;
  const OpenedSetting opened = open_setting(study, 1, other);
  CHECK(opened.other_scene);
  CHECK(opened.scene.bodies[0].shape.max.x() == 1);
}

TEST_CASE("a study file with its scene inside is read as the same runs") {
  const std::string text = study_text(grid);
  const Study study = parse_study(text, "test.json", ".");
  const std::string alone = self_contained(text, study);
  CHECK(study_identity(parse_study(alone, "elsewhere", "/")) == study_identity(study));
  CHECK(self_contained(alone, parse_study(alone, "elsewhere", "/")) == alone);
}
