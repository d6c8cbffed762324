// pushforward compare: what it finds and how it ends.
#include <doctest/doctest.h>

#include "core/output/compare.hpp"
#include "core/output/read_particles.hpp"
#include "program.hpp"

using namespace pf::test;

namespace {

void run(const Workplace& here, const std::string& folder, const std::string& options = "") {
  const Outcome outcome = here.run("run scene.json --quiet --out " + folder +
                                   " --set '/probes/-={\"name\":\"tip\",\"at\":[1,1]}' " + options);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
}

const pf::FieldDifference* find(const pf::Comparison& comparison, const std::string& file, const std::string& field) {
  for (const pf::FieldDifference& f : comparison.fields)
    if (f.file == file && f.field == field) return &f;
  return nullptr;
}

}  // namespace

TEST_CASE("compare: a run equals itself; exit status 1 above the tolerance, 0 within it") {
  const Workplace here;
  here.put("scene.json", falling_block);
  run(here, "a", "--export=vtk");
  run(here, "b", "--export=vtk");
  run(here, "c", "--export=vtk --set '/gravity=[0,-10.1]'");
  const Outcome same = here.run("compare a b");
  CHECK(same.status == 0);
  CHECK(same.out.find("within the tolerance 0") != std::string::npos);
  // In free fall everything is proportional to g: 0.1 of 10.1.
  CHECK(here.run("compare a c").status == 1);
  CHECK(here.run("compare a c --tolerance 0.0098").status == 1);
  CHECK(here.run("compare a c --tolerance 0.01").status == 0);
}

TEST_CASE("compare: wrong folders and numbers are refused") {
  const Workplace here;
  here.put("scene.json", falling_block);
  run(here, "a");
  CHECK(here.run("compare a nothing").status == 4);
  CHECK(here.run("compare a").status == 2);
  CHECK(here.run("compare a a --tolerance -1").status == 2);
  std::filesystem::create_directory(here / "b");
  here.put("b/stats.csv", "step,time\n0,0,1\n");
  const Outcome broken = here.run("compare a b");
  CHECK(broken.status == 2);
  CHECK(broken.err.find("stats.csv") != std::string::npos);
  CHECK(broken.err.find("line 2") != std::string::npos);
}

TEST_CASE("compare: free fall with another g differs by what mechanics says, whatever the export's format") {
  const Workplace here;
  here.put("scene.json", falling_block);
  for (const char* format : {"vtk", "ply", "csv"}) {
    CAPTURE(format);
    run(here, "a", std::string("--export=") + format);
    run(here, "b", std::string("--set '/gravity=[0,-12]' --export=") + format);
    const pf::Comparison result = pf::compare_runs(here / "a", here / "b");
    const double t = 0.05, ratio = 2.0 / 12;
    const auto* velocity = find(result, "export", "velocity");
    REQUIRE(velocity != nullptr);
    CHECK(velocity->largest == doctest::Approx(2 * t).epsilon(1e-6));
    CHECK(velocity->relative() == doctest::Approx(ratio).epsilon(1e-6));
    const auto* tip = find(result, "probes.csv", "tip position");
    REQUIRE(tip != nullptr);
    CHECK(tip->relative() == doctest::Approx(ratio).epsilon(1e-6));
    CHECK(tip->time == doctest::Approx(t));
    const auto* momentum = find(result, "stats.csv", "momentum");
    REQUIRE(momentum != nullptr);
    CHECK(momentum->largest == doctest::Approx(250 * 2 * t).epsilon(1e-6));
    const auto* volume = find(result, "export", "X");
    REQUIRE(volume != nullptr);
    CHECK(volume->largest == 0);
  }
}

TEST_CASE("compare: rows are matched in time; another end is a difference") {
  const Workplace here;
  here.put("scene.json", falling_block);
  run(here, "a");
  run(here, "b", "--set /time/step=0.02");
  const pf::Comparison steps = pf::compare_runs(here / "a", here / "b");
  // Momentum is linear in time: interpolation between the longer steps is exact.
  CHECK(find(steps, "stats.csv", "momentum")->relative() < 1e-9);
  CHECK_FALSE(find(steps, "stats.csv", "dt")->judged);
  run(here, "b", "--until 0.04");
  const pf::Comparison ends = pf::compare_runs(here / "a", here / "b");
  CHECK(find(ends, "stats.csv", "end of the run")->relative() == doctest::Approx(0.2));
  CHECK(find(ends, "stats.csv", "momentum")->relative() == 0);
}
