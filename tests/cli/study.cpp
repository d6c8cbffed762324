// pushforward study: what it writes, how it ends, killed and resumed.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "core/output/csv_table.hpp"
#include "program.hpp"

using namespace pf::test;
namespace fs = std::filesystem;

namespace {

const char* const small_study = R"({"name": "Small", "scene": "scene.json", "cost": "work",
  "vary": {"/time/step": [0.01, 0.005], "/transfer/type": ["flip", "apic"]}})";

// About 200 ms a run: something to interrupt.
const char* const long_study =
    R"({"scene": "scene.json", "cost": "work", "set": {"/time/end": 3, "/grid/spacing": 0.03125},
  "vary": {"/time/step": [0.010, 0.011, 0.012, 0.013, 0.014, 0.015, 0.016, 0.017]}})";

std::string without_time(const fs::path& file) {
  const pf::CsvTable table = pf::read_csv(file);
  std::string kept;
  for (const auto& row : table.rows)
    for (std::size_t k = 0; k < row.size(); ++k)
      if (!table.header[k].starts_with("wall_")) kept += row[k] + (k + 1 == row.size() ? "\n" : ",");
  return kept;
}

}  // namespace

TEST_CASE("study writes results, charts and the best settings, and says so in one line") {
  const Workplace here;
  here.put("scene.json", falling_block);
  here.put("study.json", small_study);
  const Outcome outcome = here.run("study study.json --out o");
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 1);
  CHECK(outcome.err.find("[4/4]") != std::string::npos);
  for (const char* file : {"results.csv", "chart.svg", "chart.png", "chart.csv", "best.json", "study.json"})
    CHECK(fs::exists(here / "o" / file));
  const pf::CsvTable table = pf::read_csv(here / "o/results.csv");
  CHECK(table.rows.size() == 4);
  for (const char* column : {"/time/step", "/transfer/type", "status", "class", "wall_s", "wall_min_s", "wall_max_s",
                             "work", "error_l2", "error_max", "energy_lost", "energy_gained", "momentum_drift",
                             "stress_noise", "steps", "newton_iterations", "linear_iterations"})
    CHECK(table.find(column) >= 0);
  const auto about = nlohmann::json::parse(pf::read_file(here / "o/study.json"));
  CHECK(about["thresholds"]["growing"] == 0.05);
  CHECK(about["finished"] == 4);
  const Outcome quiet = here.run("study study.json --out p --quiet");
  CHECK(quiet.status == 0);
  CHECK(quiet.err.empty());
  CHECK(without_time(here / "o/results.csv") == without_time(here / "p/results.csv"));
}

TEST_CASE("a study that is killed or interrupted goes on where it was") {
  const Workplace here;
  here.put("scene.json", falling_block);
  here.put("study.json", long_study);
  const auto begin = std::chrono::steady_clock::now();
  REQUIRE(here.run("study study.json --out whole --quiet").status == 0);
  // On a machine of any speed a third of this is too short for all of it.
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begin;
  const std::string third = std::to_string(whole.count() / 3);
  CHECK(here.run("study study.json --out parts --quiet", "timeout --foreground --preserve-status -s INT " + third)
            .status == 130);
  const std::size_t kept = pf::read_csv(here / "parts/results.csv").rows.size();
  CHECK(kept < 8);
  here.run("study study.json --out parts --quiet", "timeout -s KILL " + third);
  CHECK(pf::read_csv(here / "parts/results.csv").rows.size() >= kept);
  const Outcome rest = here.run("study study.json --out parts --jobs 2");
  CAPTURE(rest.err);
  CHECK(rest.status == 0);
  CHECK(without_time(here / "whole/results.csv") == without_time(here / "parts/results.csv"));
  // Now it is complete: the same command runs nothing and says the same.
  const Outcome again = here.run("study study.json --out parts");
  CHECK(again.status == 0);
  CHECK(again.err.find("8 of them done before") != std::string::npos);
}

TEST_CASE("wrong studies: exit status 2 with file, pointer and line; 4 where there is none") {
  const Workplace here;
  here.put("scene.json", falling_block);
  here.put("study.json", "{\n\"scene\": \"scene.json\",\n\"vary\": {\"/time/stop\": [1]}}");
  const Outcome wrong = here.run("study study.json --out o");
  CHECK(wrong.status == 2);
  CHECK(wrong.err.find("study.json: /vary/~1time~1stop/0, line 3") != std::string::npos);
  CHECK(wrong.err.find("step") != std::string::npos);
  CHECK_FALSE(fs::exists(here / "o"));
  CHECK(here.run("study nothing.json --out o").status == 4);
  here.put("study.json", small_study);
  CHECK(here.run("study study.json --out /proc/nothing").status == 4);
  REQUIRE(here.run("study study.json --out o --quiet").status == 0);
  here.put("other.json", long_study);
  const Outcome other = here.run("study other.json --out o");
  CHECK(other.status == 2);
  CHECK(other.err.find("--fresh") != std::string::npos);
}
