// Adaptive runs against the front of the fixed settings beside them.
#include "core/studies/adaptive_front.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/studies/driver.hpp"
#include "small_study.hpp"

using namespace pf;

namespace {

/// Four fixed settings, then three adaptive ones.
Study study() {
  return test::small_study(R"("vary": [{"/time/step": 0.004}, {"/time/step": 0.002}, {"/time/step": 0.001},
      {"/time/step": 0.0005}, {"/time/control": "adaptive", "/time/tolerance": 0.1},
      {"/time/control": "adaptive", "/time/tolerance": 0.01}, {"/time/control": "adaptive", "/time/tolerance": 0.001}],
    "cost": "work")");
}

StudyRow row(std::size_t point, double cost, double error, RunClass behaviour = RunClass::good) {
  StudyRow r;
  r.point = point;
  r.behaviour = behaviour;
  r.work = cost;
  r.error_l2 = error;
  return r;
}

}  // namespace

TEST_CASE("the front is met between its points, at its cheap end, and left behind beyond its exact one") {
  // 0.002 is dominated; 0.0005 blew up and counts for nothing, however exact it looks.
  std::vector<StudyRow> rows{row(0, 100, 1e-2), row(1, 500, 2e-2), row(2, 10000, 1e-4),
                             row(3, 1, 1e-9, RunClass::blown_up)};
  rows.push_back(row(4, 120, 3e-2));  // the cheapest is more exact
  rows.push_back(row(5, 500, 1e-3));  // half-way: sqrt(100 * 10000) = 1000
  rows.push_back(row(6, 900, 1e-5));  // more exact than all
  const auto runs = adaptive_against_fixed(study(), rows);
  REQUIRE(runs.size() == 3);
  CHECK(runs[0].front_cost == 100);
  CHECK(runs[0].ratio == doctest::Approx(1.2));
  CHECK(runs[1].front_cost == doctest::Approx(1000).epsilon(1e-12));
  CHECK(runs[1].ratio == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(std::isnan(runs[2].front_cost));
  const std::string csv = adaptive_csv(study(), rows);
  CHECK(csv.starts_with("/time/step,/time/control,/time/tolerance,error_l2,cost,front_cost,ratio\n,adaptive,0.1,"));
  CHECK(csv.ends_with(",900,,\n"));
}

TEST_CASE("without adaptive runs, or nothing beside them, there is nothing to tell") {
  const std::vector<StudyRow> fixed{row(0, 100, 1e-2), row(1, 500, 2e-3)}, alone{row(4, 100, 1e-2)};
  CHECK(adaptive_csv(study(), fixed).empty());
  CHECK(adaptive_csv(study(), alone).empty());
}

TEST_CASE("adaptive runs of a study are compared at its times, whose fixed runs meet them") {
  Study with = test::small_study(R"("vary": [{"/time/step": 0.004}, {"/time/control": "adaptive"}],
    "reference": {"/time/step": 0.001}, "samples": 4, "cost": "work")");
  StudyDriver driver(with, {});
  REQUIRE(driver.prepare(nullptr));
  REQUIRE(driver.run(1, nullptr));
  const auto runs = adaptive_against_fixed(driver.study(), driver.rows());
  REQUIRE(runs.size() == 1);
  CHECK(runs[0].error > 0);
  CHECK(runs[0].error < 1e-2);
  CHECK(driver.rows()[1].end_time == 0.08);
}
