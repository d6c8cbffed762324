// pushforward chart: what becomes of tables, and what is refused.
#include <doctest/doctest.h>

#include <cmath>

#include "core/output/csv_table.hpp"
#include "core/studies/table_chart.hpp"
#include "program.hpp"

using namespace pf::test;

TEST_CASE("chart: columns of a run's stats, as points and as pictures") {
  const Workplace here;
  here.put("scene.json", falling_block);
  REQUIRE(here.run("run scene.json --quiet --out out").status == 0);
  const Outcome points = here.run("chart out --y kinetic_energy,potential_energy --out points.csv");
  CAPTURE(points.err);
  REQUIRE(points.status == 0);
  // Of 6 states two lines; what falls loses as much as it gains.
  const pf::CsvTable table = pf::read_csv(here.path() / "points.csv");
  REQUIRE(table.rows.size() == 12);
  CHECK(table.header[0] == "series");
  CHECK(table.rows.front()[0] == "Kinetic energy");
  const double gained = pf::csv_value(table.rows[5][2]) - pf::csv_value(table.rows[0][2]);
  const double lost = pf::csv_value(table.rows[6][2]) - pf::csv_value(table.rows[11][2]);
  CHECK(gained > 0);
  CHECK(lost == doctest::Approx(gained).epsilon(0.3));  // backward Euler's own share
  REQUIRE(here.run("chart out/stats.csv --y kinetic_energy --title Fall --out e.svg").status == 0);
  const std::string svg = pf::read_file(here.path() / "e.svg");
  CHECK(svg.find("Fall") != std::string::npos);
  CHECK(svg.find("Kinetic energy") != std::string::npos);
  REQUIRE(here.run("chart out --y min_J --out e.png --size 400x300 --dark").status == 0);
  CHECK(pf::read_file(here.path() / "e.png").substr(1, 3) == "PNG");
}

TEST_CASE("chart: lines by the values of a column, and by tables") {
  const Workplace here;
  here.put("a.csv", "method,cost,error\nold,1,0.4\nnew,.5,0.4\nold,2,0.2\nnew,1,.2\nnew,,1\n");
  here.put("b.csv", "cost,error\n1,2\n3,4\n");
  pf::TableChart wanted{.tables = {here.path() / "a.csv"}, .x = "cost", .y = {"error"}, .lines = "method"};
  wanted.x_title = "CPU time [s]";
  const pf::Chart chart = pf::table_chart(wanted);
  REQUIRE(chart.series.size() == 2);
  CHECK(chart.series[0].label == "old");
  CHECK(chart.series[0].x == std::vector<double>{1, 2});
  CHECK(chart.series[1].y == std::vector<double>{0.4, 0.2, 1});
  CHECK(!std::isfinite(chart.series[1].x[2]));
  CHECK(chart.x.title == "CPU time");
  CHECK(chart.x.unit == "s");
  wanted.tables.push_back(here.path() / "b.csv");
  wanted.lines = "";
  const pf::Chart both = pf::table_chart(wanted);
  REQUIRE(both.series.size() == 2);
  CHECK(both.series[0].label == "a");
  CHECK(both.series[1].label == "b");
}

TEST_CASE("chart: what is wrong is said, with what is allowed") {
  const Workplace here;
  here.put("a.csv", "cost,error,name\n1,2,x\n");
  const auto refused = [&](const std::string& arguments, int status, const std::string& word) {
    const Outcome outcome = here.run("chart " + arguments);
    CAPTURE(arguments);
    CAPTURE(outcome.err);
    CHECK(outcome.status == status);
    CHECK(outcome.err.find(word) != std::string::npos);
  };
  refused("a.csv --x cost --y eror --out o.svg", 2, "error");
  refused("a.csv --x cost --y name --out o.svg", 2, "no row with numbers");
  refused("a.csv --x cost --y error --out o.gif", 2, ".svg, .png or .csv");
  refused("missing.csv --x cost --y error --out o.svg", 4, "missing.csv");
  refused("a.csv --x cost --y error --out o.svg --size 3", 2, "WIDTHxHEIGHT");
  refused("a.csv --x cost", 2, "--y");
  CHECK(!std::filesystem::exists(here.path() / "o.svg"));
}
