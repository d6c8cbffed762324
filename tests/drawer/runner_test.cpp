// The runner's threads: a study runs beside the window, is cancelled, goes on, and holds the live view while it is
// timed.
#include "app/studies/runner.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "app/studies/library.hpp"
#include "core/files.hpp"
#include "core/output/csv_table.hpp"
#include "tests/studies/small_study.hpp"
#include "tests/temporary_folder.hpp"

using namespace pf;
using namespace pf::app;
using Clock = std::chrono::steady_clock;

namespace {

const std::string twelve = R"("vary": {"/integrator/type": ["backward_euler", "symplectic_euler"],
  "/time/step": [0.004, 0.002, 0.001, 0.0005, 0.00025, 0.0002]}, "samples": 2)";

StudyFile study_file(const std::string& members) {
  return {test::study_text(members), "test", "."};
}

/// A session's side of the agreement: stands still a moment after it was asked to.
struct LiveView {
  std::atomic<bool> asked{false}, still{false};
  std::atomic<int> wakes{0}, holds{0};
  StudyHooks hooks() {
    return {[this] { ++wakes; },
            [this](bool on) {
              asked = on;
              if (on) ++holds;
              if (!on) still = false;
            },
            [this] { return still.load(); }};
  }
};

bool until(const std::function<bool()>& done) {
  const auto deadline = Clock::now() + std::chrono::minutes(2);
  while (!done()) {
    if (Clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

bool comes_to(const StudyRunner& runner, StudyStage stage) {
  return until([&] { return runner.status().stage == stage; });
}

}  // namespace

TEST_CASE("a study runs to its end, every row is handed on and on disk") {
  const test::TemporaryFolder here;
  LiveView live;
  StudyRunner runner(here.path(), {}, live.hooks());
  CHECK(runner.status().stage == StudyStage::none);
  runner.open(study_file(twelve + R"(, "cost": "work")"), true);
  CHECK(runner.status().active());
  REQUIRE(comes_to(runner, StudyStage::finished));
  const auto results = runner.results();
  REQUIRE(results);
  CHECK(results->rows.size() == 12);
  CHECK(runner.status().finished == 12);
  CHECK(runner.status().seconds_left == 0);
  CHECK(live.wakes >= 12);
  CHECK(live.holds == 0);  // not timed: it runs beside the live view
  CHECK(read_csv(results->folder / "results.csv").rows.size() == 12);
  const std::vector<LibraryEntry> earlier = earlier_studies(here.path());
  REQUIRE(earlier.size() == 1);
  CHECK(earlier[0].finished == 12);
  CHECK(earlier[0].name == "Small");
}

TEST_CASE("a cancelled study keeps its rows and goes on where it was, in the next window too") {
  const test::TemporaryFolder here;
  std::filesystem::path definition;
  std::size_t kept = 0;
  {
    LiveView live;
    StudyRunner runner(here.path(), {}, live.hooks());
    runner.open(study_file(twelve + R"(, "cost": "work")"), true);
    REQUIRE(until([&] { return runner.status().finished >= 2; }));
    runner.cancel();
    REQUIRE(until([&] { return !runner.status().active(); }));
    kept = runner.results()->rows.size();
    CHECK(kept >= 2);
    definition = runner.results()->folder / definition_name;
    runner.begin();
    REQUIRE(until([&] { return runner.status().finished > kept || runner.status().stage == StudyStage::finished; }));
    kept = runner.status().finished;
  }  // the window is closed while it runs
  LiveView live;
  StudyRunner runner(here.path(), {}, live.hooks());
  runner.open({read_file(definition), definition.string(), definition.parent_path()}, false);
  REQUIRE(until([&] { return !runner.status().active(); }));
  CHECK(runner.status().finished >= kept);
  CHECK(runner.results()->rows.size() >= kept);
  runner.begin();
  REQUIRE(comes_to(runner, StudyStage::finished));
  CHECK(runner.results()->rows.size() == 12);
  runner.begin(true);
  REQUIRE(until([&] { return runner.status().stage == StudyStage::running && runner.status().finished < 12; }));
}

TEST_CASE("timed runs wait until the live view stands still, and let go of it when they end or are cancelled") {
  LiveView live;
  StudyRunner runner({}, {}, live.hooks());
  runner.open(study_file(twelve + R"(, "repeat": 2)"), true);
  REQUIRE(until([&] { return live.asked.load(); }));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  CHECK(runner.status().finished == 0);
  live.still = true;
  REQUIRE(until([&] { return runner.status().finished >= 1; }));
  runner.cancel();
  REQUIRE(until([&] { return !live.asked.load(); }));
  REQUIRE(comes_to(runner, StudyStage::ready));
  // Cancelled while it waits: it gives up the wait.
  runner.begin();
  REQUIRE(until([&] { return live.holds == 2; }));
  runner.cancel();
  REQUIRE(comes_to(runner, StudyStage::ready));
  CHECK_FALSE(live.asked);
}

TEST_CASE("what is wrong with a study is said, and the next one runs") {
  LiveView live;
  StudyRunner runner({}, {}, live.hooks());
  runner.open({R"({"scene": 3})", "broken", "."}, true);
  REQUIRE(comes_to(runner, StudyStage::failed));
  CHECK_FALSE(runner.status().problems.empty());
  CHECK_FALSE(runner.results());
  runner.open({"not JSON at all", "broken", "."}, true);
  REQUIRE(comes_to(runner, StudyStage::failed));
  runner.open(study_file(R"("vary": {"/time/step": [0.004, 0.002]}, "cost": "work")"), true);
  REQUIRE(comes_to(runner, StudyStage::finished));
  CHECK(runner.results()->rows.size() == 2);
}

TEST_CASE("another study takes the place of one that runs") {
  const test::TemporaryFolder here;
  LiveView live;
  StudyRunner runner(here.path(), {}, live.hooks());
  runner.open(study_file(twelve + R"(, "cost": "work")"), true);
  REQUIRE(until([&] { return runner.status().finished >= 1; }));
  runner.open(study_file(R"("vary": {"/time/step": [0.004, 0.002]}, "cost": "work")"), true);
  REQUIRE(comes_to(runner, StudyStage::finished));
  CHECK(study_size(*runner.results()->study) == 2);
  CHECK(earlier_studies(here.path()).size() == 2);  // the first one's rows are kept
}

TEST_CASE("the fine run comes first and tells how far it is") {
  LiveView live;
  StudyRunner runner({}, {}, live.hooks());
  runner.open(
      study_file(R"("vary": {"/time/step": [0.004, 0.002]}, "reference": {"/time/step": 2e-5}, "cost": "work")"), true);
  REQUIRE(until([&] { return runner.status().stage == StudyStage::reference && runner.status().reference_share > 0; }));
  REQUIRE(comes_to(runner, StudyStage::finished));
  for (const StudyRow& row : runner.results()->rows) CHECK(row.error_l2 > 0);
}
