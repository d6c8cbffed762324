// Checks of a study's numbers: what is refused, what passes and fails.
#include "core/studies/checks.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/studies/probe_track.hpp"
#include "small_study.hpp"

using namespace pf;
using namespace pf::test;

namespace {

const std::string vary =
    R"("vary": {"basis": [{"label": "one", "/grid/basis": "linear"}, {"label": "two", "/grid/basis": "quadratic"}],
                                     "/grid/spacing": [0.25, 0.125, 0.0625]})";

Study with_check(const std::string& check) {
  return small_study(vary + R"(, "checks": [)" + check + "]");
}

/// Errors of 1, 1/4, 1/8 for the first basis, ten times as much for the second.
std::vector<StudyRow> rows() {
  std::vector<StudyRow> all;
  for (std::size_t k = 0; k < 6; ++k) {
    StudyRow row;
    row.point = k;
    row.dx = 0.25 / static_cast<double>(1 << k % 3);
    row.error_l2 = (k % 3 == 0 ? 1 : k % 3 == 1 ? 0.25 : 0.125) * (k < 3 ? 1 : 10);
    all.push_back(row);
  }
  return all;
}

CheckResult result(const std::string& check) {
  const Study study = with_check(check);
  return evaluate(study, study.checks.front(), rows());
}

}  // namespace

TEST_CASE("checks: the last row, all rows, the rows of a setting, an exact value, an order") {
  CheckResult found = result(R"({"name": "n", "per": 2, "where": {"basis": "one"}, "below": 0.0626})");
  CHECK(found.passed);
  CHECK(found.worst == 0.0625);
  CHECK(result(R"({"name": "n", "where": {"basis": "one", "/grid/spacing": 0.25}, "below": 1.5})").worst == 1);
  found = result(R"({"name": "n", "where": {"basis": "one"}, "rows": "all", "below": 0.5})");
  CHECK_FALSE(found.passed);
  CHECK(found.values.size() == 3);
  CHECK(found.worst == 1);
  CHECK(result(R"({"name": "n", "where": {"basis": "two"}, "exact": 1, "below": 0.3})").worst == doctest::Approx(0.25));
  found = result(R"({"name": "n", "where": {"basis": "two"}, "order_in": "dx", "above": 0.9, "below": 1.1})");
  CHECK(found.passed);
  CHECK(found.worst == doctest::Approx(1));
  found = result(R"({"name": "n", "where": {"basis": "two"}, "order_in": "dx", "rows": "all", "below": 1.1})");
  CHECK_FALSE(found.passed);
  CHECK(found.worst == doctest::Approx(2));
}

TEST_CASE("checks: nothing passes that was not measured, failed or is missing") {
  const Study study = with_check(R"({"name": "n", "below": 1e9, "above": -1e9})");
  std::vector<StudyRow> some = rows();
  CHECK(evaluate(study, study.checks[0], some).passed);
  some.back().error_l2 = not_measured;
  CHECK_FALSE(evaluate(study, study.checks[0], some).passed);
  some.back() = rows().back();
  some.back().status = RowStatus::failed;
  some.back().reason = "Newton";
  CHECK_FALSE(evaluate(study, study.checks[0], some).passed);
  CHECK(evaluate(study, study.checks[0], some).reason == "Newton");
  some.pop_back();
  CHECK_FALSE(evaluate(study, study.checks[0], some).passed);
}

TEST_CASE("checks: what cannot be judged is refused where it stands") {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"name": "n"})", "/checks/0"},
      {R"({"name": "n", "of": "error_l3", "below": 1})", "/checks/0/of"},
      {R"({"name": "n", "order_in": "dxx", "below": 1})", "/checks/0/order_in"},
      {R"({"name": "n", "above": 2, "below": 1})", "/checks/0/above"},
      {R"({"name": "n", "below": 1, "where": {"/time/step": 1}})", "/checks/0/where/~1time~1step"},
      {R"({"name": "n", "below": 1, "where": {"basis": "three"}})", "/checks/0/where"},
      {R"({"name": "n", "below": 1, "per": 0})", "/checks/0/per"},
      {R"({"name": "n", "below": 1, "rows": "some"})", "/checks/0/rows"}};
  for (const auto& [check, pointer] : cases) {
    INFO(std::string(check));
    const auto problems = study_problems(study_text(vary + R"(, "checks": [)" + check + "]"));
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].pointer == pointer);
    CHECK(problems[0].line > 0);
  }
}

TEST_CASE("a probe's displacement and the period of its swing") {
  ProbeTrack track;
  for (int k = 0; k <= 500; ++k) {
    const double t = 0.01 * k;
    track.add(t, Vec3(2 + 0.1 * std::cos(3 * t), 1 - 0.5 * std::sin(4 * t), 0));
  }
  StudyRow row;
  track.fill(row);
  CHECK(row.probe_period == doctest::Approx(3.141592653589793 / 2).epsilon(1e-5));
  CHECK(row.probe_ux == doctest::Approx(0.1 * (std::cos(15.) - 1)));
  CHECK(row.probe_uy == doctest::Approx(-0.5 * std::sin(20.)));
  StudyRow none;
  ProbeTrack().fill(none);
  CHECK(std::isnan(none.probe_uy));
  CHECK(std::isnan(none.probe_period));
}
