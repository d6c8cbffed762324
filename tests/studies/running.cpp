// Studies run: the rows, resuming, bad runs, the same rows whatever the number of jobs.
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>

#include "core/files.hpp"
#include "core/output/csv_table.hpp"
#include "core/studies/driver.hpp"
#include "core/studies/results.hpp"
#include "core/studies/study_charts.hpp"
#include "small_study.hpp"
#include "tests/temporary_folder.hpp"

using namespace pf;
using namespace pf::test;

namespace {

const std::string grid = R"("vary": {"/integrator/type": ["backward_euler", "symplectic_euler"],
  "/time/step": [0.008, 0.004, 0.002]}, "cost": "work", "samples": 2)";

/// results.csv without its timings.
std::string without_time(const std::filesystem::path& file) {
  const CsvTable table = read_csv(file);
  std::string kept;
  for (const auto& row : table.rows)
    for (std::size_t k = 0; k < row.size(); ++k)
      if (!table.header[k].starts_with("wall_")) kept += row[k] + (k + 1 == row.size() ? "\n" : ",");
  return kept;
}

void run_all(const Study& study, const std::filesystem::path& folder, int jobs = 1) {
  StudyDriver driver(study, {.folder = folder, .cache = {}, .fresh = false});
  REQUIRE(driver.prepare(nullptr));
  REQUIRE(driver.run(jobs, nullptr));
}

}  // namespace

TEST_CASE("two identical studies agree in everything but time, whatever the number of jobs") {
  const TemporaryFolder here;
  const Study study = small_study(grid);
  run_all(study, here / "one");
  run_all(study, here / "two", 2);
  CHECK(without_time(here / "one/results.csv") == without_time(here / "two/results.csv"));
  CHECK(read_csv(here / "one/results.csv").rows.size() == 6);
}

TEST_CASE("a study that was cut off goes on where it was, and ends as if it never had been") {
  const TemporaryFolder here;
  const Study study = small_study(grid);
  run_all(study, here / "whole");
  {
    StudyDriver driver(study, {.folder = here / "parts", .cache = {}, .fresh = false});
    REQUIRE(driver.prepare(nullptr));
    std::atomic<bool> cancel{false};
    CHECK_FALSE(driver.run(1, &cancel, [&](const StudyRow&) { cancel = driver.finished() == 2; }));
    CHECK(driver.finished() == 2);
  }
  CHECK(read_csv(here / "parts/results.csv").rows.size() == 2);
  StudyDriver driver(study, {.folder = here / "parts", .cache = {}, .fresh = false});
  CHECK(driver.resumed() == 2);
  int more = 0;
  CHECK(driver.run(1, nullptr, [&](const StudyRow&) { ++more; }));
  CHECK(more == 4);
  CHECK(without_time(here / "whole/results.csv") == without_time(here / "parts/results.csv"));
  CHECK(driver.seconds_left() == 0);
}

TEST_CASE("another study's folder is left alone, unless told") {
  const TemporaryFolder here;
  run_all(small_study(grid), here / "out");
  const std::string before = read_file(here / "out/results.csv");
  const Study other = small_study(R"("vary": {"/time/step": [0.004]})");
  CHECK_THROWS_AS(StudyDriver(other, {.folder = here / "out", .cache = {}, .fresh = false}), InputError);
  CHECK(read_file(here / "out/results.csv") == before);
  const StudyDriver fresh(other, {.folder = here / "out", .cache = {}, .fresh = true});
  CHECK(fresh.resumed() == 0);
}

TEST_CASE("a bad run is a row with its class and reason") {
  const Study study =
      small_study(R"("vary": {"/transfer/type": ["apic", "pic"], "/transfer/velocity_mass": ["lumped", "consistent"],
    "/integrator/type": ["backward_euler", "symplectic_euler"]}, "set": {"/time/step": 0.02, "/time/end": 0.4}, "cost": "work")");
  StudyDriver driver(study, {});
  REQUIRE(driver.run(1, nullptr));
  const std::vector<StudyRow> rows = driver.rows();
  REQUIRE(rows.size() == 8);
  CHECK(rows[0].behaviour == RunClass::damped);    // backward Euler, w dt = 0.3
  CHECK(rows[1].behaviour == RunClass::blown_up);  // c dt/dx = 1.6, above the explicit limit
  CHECK(rows[1].status == RowStatus::unstable);
  CHECK(rows[2].status == RowStatus::failed);
  CHECK(rows[2].reason.find("velocity_mass") != std::string::npos);
}

TEST_CASE("backward Euler loses what theory says: E/E0 = (1 + w^2 dt^2)^-n") {
  const Study study = small_study(R"("vary": {"/time/step": [0.008, 0.004]}, "cost": "work")");
  StudyDriver driver(study, {});
  REQUIRE(driver.run(1, nullptr));
  for (const StudyRow& row : driver.rows()) {
    const double w = 5 * std::acos(-1.0), left = std::pow(1 + w * w * row.dt * row.dt, -0.08 / row.dt);
    CHECK(row.energy_lost == doctest::Approx(1 - left).epsilon(0.05));
    CHECK(row.energy_change == doctest::Approx(-row.energy_lost).epsilon(1e-9));
    CHECK(row.energy_gained == 0);
  }
}

TEST_CASE("measured against a fine run, a run with its settings has no error and a coarser one some") {
  const Study study = small_study(R"("vary": {"/time/step": [0.004, 0.001]}, "reference": {"/time/step": 0.001},
    "samples": 4, "cost": "work")");
  const TemporaryFolder here;
  StudyDriver driver(study, {.folder = {}, .cache = here.path(), .fresh = false});
  REQUIRE(driver.prepare(nullptr));
  REQUIRE(driver.run(1, nullptr));
  const std::vector<StudyRow> rows = driver.rows();
  CHECK(rows[1].error_l2 == 0);
  CHECK(rows[1].error_stress_max == 0);
  CHECK(rows[0].error_l2 > 1e-5);
  // The second time it comes from the cache, and gives the same rows.
  StudyDriver again(study, {.folder = {}, .cache = here.path(), .fresh = false});
  double told = 0;
  REQUIRE(again.prepare(nullptr, [&](double share) { told = share; }));
  CHECK(told == 0);
  REQUIRE(again.run(1, nullptr));
  CHECK(again.rows()[0].error_l2 == rows[0].error_l2);
}

TEST_CASE("charts are made of whatever rows there are, and know which setting a point is") {
  const Study study = small_study(grid);
  StudyDriver driver(study, {});
  CHECK(study_figures(study, driver.rows()).size() == 2);  // error against cost, error against dt
  REQUIRE(driver.run(1, nullptr));
  const TemporaryFolder here;
  const std::vector<StudyFigure> figures = study_figures(study, driver.rows());
  const StudyFigure& figure = figures.front();
  REQUIRE(figure.chart.series.size() >= 1);
  REQUIRE(figure.point.size() == figure.chart.series.size());
  for (std::size_t s = 0; s < figure.point.size(); ++s)
    for (std::size_t k = 0; k < figure.point[s].size(); ++k)
      for (const StudyRow& row : driver.rows())
        if (row.point == figure.point[s][k]) CHECK(figure.chart.series[s].x[k] == row.work);
  write_figures(figures, study, here.path());
  for (const char* file : {"chart.svg", "chart.png", "chart.csv", "chart-dt.svg"})
    CHECK(std::filesystem::file_size(here / file) > 200);
  const auto best = best_document(study, driver.rows());
  REQUIRE(best["best"].size() > 0);
  CHECK(best["best"][0]["error_l2"].get<double>() <= best["best"][0]["tolerance"].get<double>());
}

TEST_CASE("every shipped study is sound, its first run comes to something, and its charts can be drawn") {
  const std::filesystem::path folder = std::filesystem::path(PUSHFORWARD_SOURCE) / "assets/studies";
  const std::string page = read_file(std::filesystem::path(PUSHFORWARD_SOURCE) / "docs/charts.md");
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    CAPTURE(entry.path().string());
    Study study = load_study(entry.path());
    CHECK_FALSE(study.name.empty());
    CHECK_FALSE(study.about.empty());
    CHECK(page.find("(images/charts/" + entry.path().stem().string()) != std::string::npos);
    // The coarsest run, for a look: settings are kept, repeats and the fine run are not.
    study.repeat = 1;
    study.reference = study.reference == ReferenceKind::run ? ReferenceKind::none : study.reference;
    StudyDriver driver(study, {});
    const std::optional<StudyRow> row = driver.advance(nullptr);
    REQUIRE(row.has_value());
    CHECK(row->steps > 0);
    for (const StudyFigure& figure : study_figures(study, driver.rows())) CHECK_FALSE(figure.chart.title.empty());
    ++count;
  }
  CHECK(count >= 9);
}

TEST_CASE("a run whose energy leaves all bounds is stopped, and says so") {
  const Study study = small_study(
      R"("vary": {"/time/step": [0.02]}, "set": {"/integrator/type": "symplectic_euler", "/time/end": 4}, "cost": "work")");
  StudyDriver driver(study, {});
  REQUIRE(driver.run(1, nullptr));
  const StudyRow row = driver.rows().front();
  CHECK(row.status == RowStatus::unstable);
  CHECK(row.behaviour == RunClass::blown_up);
  CHECK(row.reason.find("stopped: its energy had grown beyond 10 times") == 0);
}

TEST_CASE("a body without stress is not called noisy") {
  const auto noise = [](const std::string& velocity) {
    std::string text = study_text(R"("vary": {"/transfer/type": ["apic"]}, "cost": "work", "samples": 2)");
    // Free flight instead of the bar's swing.
    const auto from = text.find("\"constraints\""), to = text.find("\"exact\"");
    text.replace(from, to - from, "");
    const auto exact = text.find("\"exact\""), end = text.find("},", exact);
    text.replace(exact, end - exact + 1, "\"gravity\": [0, 0]}");
    text.replace(text.find("\"shape\""), 7, R"("velocity": )" + velocity + R"(, "shape")");
    StudyDriver driver(parse_study(text, "test.json", "."), {});
    REQUIRE(driver.run(1, nullptr));
    return driver.rows().front();
  };
  const StudyRow flying = noise("[1, 0.5]");
  CHECK(std::isnan(flying.stress_noise));
  CHECK(flying.behaviour != RunClass::noisy);
  CHECK(noise(R"x(["0.5*sin(3*X)", 0])x").stress_noise > 0);  // that one is deformed
}
