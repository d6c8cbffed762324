// pushforward verify: what passes, what fails, what it writes.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "program.hpp"

using namespace pf::test;

namespace {

std::string case_with(const std::string& below) {
  return R"({"name": "Fall", "scene": "scene.json", "set": {"/time/end": 0.05}, "cost": "work", "vary": {"/time/step": [0.01, 0.005]},
    "checks": [{"name": "steps", "of": "steps", "exact": 10, "below": )" +
         below +
         R"(, "peer": "someone"}, {"name": "dt", "of": "dt", "order_in": "steps", "above": -1.01, "below": -0.99}]})";
}

}  // namespace

TEST_CASE("verify: the quick cases pass") {
  const Workplace here;
  const Outcome outcome = here.run("verify quick --json all.json");
  CAPTURE(outcome.out);
  CHECK(outcome.status == 0);
  const auto all = nlohmann::json::parse(pf::read_file(here / "all.json"));
  CHECK(all["cases"].size() >= 4);
  for (const auto& c : all["cases"]) CHECK(c["passed"] == true);
}

TEST_CASE("verify: every failure of the gallery shows, and its cure cures it") {
  const Workplace here;
  const Outcome outcome = here.run("verify failures --json all.json");
  CAPTURE(outcome.out);
  CHECK(outcome.status == 0);
  const auto all = nlohmann::json::parse(pf::read_file(here / "all.json"));
  CHECK(all["cases"].size() >= 12);
  for (const auto& c : all["cases"]) {
    CAPTURE(c["case"]);
    CHECK(c["passed"] == true);
    CHECK(c["checks"].size() >= 2);  // the failure and the cure
  }
}

TEST_CASE("verify: a file of one's own, exit status 1 where a check fails, results kept on demand") {
  const Workplace here;
  here.put("scene.json", falling_block);
  here.put("good.json", case_with("0.5"));
  here.put("bad.json", case_with("-0.5"));
  CHECK(here.run("verify good.json").status == 0);
  const Outcome outcome = here.run("verify good.json bad.json --json r.json --out kept");
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("FAIL  steps") != std::string::npos);
  CHECK(outcome.out.find("peer: someone") != std::string::npos);
  CHECK(outcome.out.find("1 of 2 cases passed, 4 checks") != std::string::npos);
  const auto all = nlohmann::json::parse(pf::read_file(here / "r.json"));
  CHECK(all["cases"][1]["passed"] == false);
  CHECK(all["cases"][1]["checks"][0]["value"] == 0);
  CHECK(all["cases"][1]["checks"][1]["passed"] == true);
  CHECK(std::filesystem::exists(here / "kept" / "good" / "results.csv"));
}

TEST_CASE("verify: lists its cases; a wrong name, and a study without checks, are told") {
  const Workplace here;
  CHECK(here.run("verify --list").out.find("\nvortex ") != std::string::npos);
  const Outcome wrong = here.run("verify vortx");
  CHECK(wrong.status == 4);
  CHECK(wrong.err.find("did you mean vortex?") != std::string::npos);
  here.put("scene.json", falling_block);
  here.put("study.json", R"({"scene": "scene.json", "vary": {"/time/step": [0.01]}})");
  const Outcome empty = here.run("verify study.json");
  CHECK(empty.status == 2);
  CHECK(empty.err.find("/checks") != std::string::npos);
}

TEST_SUITE("long") {
  TEST_CASE("verify: all cases pass") {
    const Workplace here;
    const Outcome outcome = here.run("verify");
    CAPTURE(outcome.out);
    CHECK(outcome.status == 0);
  }
}
