// The account of the energy as a file: it closes, and says the same as the reports.
#include "core/output/energy_account.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/scene/scene_io.hpp"
#include "core/simulation.hpp"

using namespace pf;

namespace {

std::vector<StepReport> falling(bool counted) {
  const Scene scene = parse_scene(R"({"dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.1},
      "time": {"end": 0.5, "step": 0.01}, "transfer": {"type": "pic"},
      "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
      "bodies": [{"name": "ball", "material": "rubber", "shape": {"type": "ball", "center": [0, 0.5], "radius": 0.4}}],
      "boundaries": [{"shape": {"type": "half_space", "point": [0, 0], "normal": [0, 1]}, "contact": "stick"}]})",
                                  "test");
  const auto simulation = make_simulation(scene, {1, ""});
  std::vector<StepReport> reports{simulation->report()};
  for (int k = 0; k < 40; ++k) {
    simulation->set_ledger(counted || k >= 10);
    REQUIRE(simulation->step().status == StepStatus::accepted);
    reports.push_back(simulation->report());
  }
  return reports;
}

std::vector<std::vector<double>> numbers(const std::string& csv) {
  std::istringstream in(csv);
  std::string line;
  std::getline(in, line);
  CHECK(line == EnergyAccount::header());
  std::vector<std::vector<double>> rows;
  while (std::getline(in, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

}  // namespace

TEST_CASE("the account closes: what came in and what the numerics made adds up to the change, to rounding") {
  const std::vector<StepReport> reports = falling(true);
  const auto rows = numbers(energy_account_csv(reports));
  REQUIRE(rows.size() == reports.size());
  const std::size_t causes = energy_causes().size();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    REQUIRE(rows[k].size() == 8 + causes);
    CHECK(rows[k][0] == static_cast<double>(reports[k].step));
    CHECK(rows[k][1] == reports[k].time);
    CHECK(rows[k][5] == reports[k].balance.total());
    double sum = 0;
    for (std::size_t c = 0; c < causes; ++c) sum += rows[k][7 + c];
    CHECK(rows[k][6] == doctest::Approx(reports[k].balance.total() - reports[0].balance.total()));
    CHECK(std::abs(rows[k][6] - sum) < 1e-9 * std::abs(reports[0].balance.total()));
    CHECK(std::abs(rows[k].back() - (rows[k][6] - sum)) < 1e-12 * std::abs(reports[0].balance.total()));
  }
  CHECK(rows.back()[6] < -1);  // PIC has lost some
}

TEST_CASE("an account begins where counting did; JSON has the same rows") {
  const std::vector<StepReport> reports = falling(false);
  const auto rows = numbers(energy_account_csv(reports));
  REQUIRE(rows.size() == 31);
  CHECK(rows[0][0] == 10);
  for (std::size_t k = 6; k < rows[0].size(); ++k) CHECK(rows[0][k] == 0);
  const auto document = nlohmann::json::parse(energy_account_json(reports));
  CHECK(document["format"] == "pushforward/energy-account");
  CHECK(document["columns"].size() == rows[0].size());
  REQUIRE(document["rows"].size() == rows.size());
  CHECK(document["rows"][30][8].get<double>() == rows[30][8]);
  CHECK(energy_account_csv({}) == EnergyAccount::header() + "\n");
}
