// pushforward advise: its table, its file, and what it refuses.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "program.hpp"

using namespace pf::test;

TEST_CASE("advise: trials as a table and a file; advice is one of them, as --set would take it") {
  const Workplace here;
  here.put("scene.json", falling_block);
  const Outcome outcome = here.run("advise scene.json --at 0.02 --json advice.json --set /time/step=1e-4");
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.find("as it is") != std::string::npos);
  const auto report = nlohmann::json::parse(pf::read_file(here / "advice.json"));
  CHECK(report["time"].get<double>() == doctest::Approx(0.02));
  REQUIRE(report["trials"].size() > 3);
  CHECK(report["trials"][0]["set"].empty());
  for (const auto& trial : report["trials"])
    if (trial["came_through"]) CHECK(trial["error"].get<double>() >= trial["distance"].get<double>());
  // A block that only falls needs no short steps.
  REQUIRE_FALSE(report["advice"].empty());
  for (const auto& k : report["advice"]) {
    const auto& trial = report["trials"][k.get<std::size_t>()];
    CHECK_FALSE(trial["set"].empty());
    for (const auto& [pointer, value] : trial["set"].items())
      CHECK(outcome.out.find("--set " + pointer + "=") != std::string::npos);
  }
}

TEST_CASE("advise: refuses what no trial could be made of") {
  const Workplace here;
  here.put("scene.json", falling_block);
  CHECK(here.run("advise nothing.json").status == 4);
  CHECK(here.run("advise scene.json --at -1").status == 2);
  CHECK(here.run("advise").status == 2);
  CHECK(here.run("advise scene.json --set /time/step=0").status == 2);
}
