#include "core/output/checkpoint.hpp"

#include <doctest/doctest.h>

#include "core/output/run_folder.hpp"
#include "core/output/stats.hpp"
#include "core/output/summary.hpp"
#include "fake_simulation.hpp"
#include "scene.hpp"

using namespace pf;
using namespace pf::test;

namespace {

void run_with_outputs(FreeFlight& simulation, const Scene& scene, const RunFolder& folder, const Checkpoint* from,
                      const RunLimits& limits) {
  const Kept kept = prepare_run_folder(folder, scene, from != nullptr ? &from->header : nullptr);
  StatsWriter stats(folder.stats(), scene, kept.step);
  CheckpointWriter checkpoints(folder.checkpoints(), scene, 0.3, simulation.time(), from != nullptr ? 2 : 0);
  Runner runner(simulation, from != nullptr ? from->header.cursor : RunCursor{});
  runner.add(stats);
  runner.add(checkpoints);
  runner.run(limits);
}

const char* const flight = R"(, "events": [{"time": 0.2, "set": {"/solver/max_newton": 9}}])";

}  // namespace

TEST_CASE("a run that is continued from a checkpoint writes the same stats.csv as one that never stopped") {
  const Scene scene = small_scene(2, time_member(1, 0.1, 0.25) + flight);
  const TemporaryFolder whole, parts;
  FreeFlight uninterrupted(scene);
  run_with_outputs(uninterrupted, scene, {whole.path()}, nullptr, {});

  FreeFlight first(scene);
  run_with_outputs(first, scene, {parts.path()}, nullptr, {.steps = 5});
  const auto file = RunFolder{parts.path()}.checkpoints() / "000001.pfc";
  const Checkpoint checkpoint = read_checkpoint(file);
  CHECK(checkpoint.header.step == 3);
  CHECK(checkpoint.header.cursor.frames == 2);
  CHECK(checkpoint.header.cursor.events == 1);
  FreeFlight second(scene);
  resume(second, scene, checkpoint, file.string());
  CHECK(second.report().step == 3);
  CHECK(second.scene().solver.max_newton == 9);
  run_with_outputs(second, scene, {parts.path()}, &checkpoint, {});

  CHECK(read_file(whole / "stats.csv") == read_file(parts / "stats.csv"));
  for (const char* name : {"000000.pfc", "000001.pfc", "000002.pfc", "000003.pfc", "000004.pfc"}) {
    CAPTURE(name);
    CHECK(read_file(RunFolder{whole.path()}.checkpoints() / name) ==
          read_file(RunFolder{parts.path()}.checkpoints() / name));
  }
}

TEST_CASE("checkpoints that do not fit are refused with the reason") {
  const TemporaryFolder folder;
  const Scene scene = small_scene(2, time_member(1, 0.1, 0.25));
  FreeFlight simulation(scene);
  CheckpointWriter writer(folder.path(), scene, 0.5, 0);
  Runner runner(simulation);
  runner.add(writer);
  runner.run();
  const auto file = folder / "000001.pfc";
  const std::string bytes = read_file(file);

  SUBCASE("of another scene") {
    const Scene other = small_scene(2, time_member(1, 0.2, 0.25));
    FreeFlight another(other);
    CHECK_THROWS_WITH_AS(resume(another, other, read_checkpoint(file), file.string()),
                         doctest::Contains("another scene"), InputError);
  }
  SUBCASE("the end, the frames and the name may differ") {
    const Scene longer = small_scene(2, time_member(2, 0.1, 0.5));
    FreeFlight another(longer);
    resume(another, longer, read_checkpoint(file), file.string());
    CHECK(another.report().step == 5);
  }
  SUBCASE("cut off") {
    for (const std::size_t length : {std::size_t{0}, std::size_t{10}, std::size_t{60}, bytes.size() - 1}) {
      write_atomically(file, bytes.substr(0, length));
      CHECK_THROWS_AS(read_checkpoint(file), InputError);
    }
  }
  SUBCASE("one bit changed in the state") {
    std::string damaged = bytes;
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    write_atomically(file, damaged);
    CHECK_THROWS_WITH_AS(read_checkpoint(file), doctest::Contains("damaged"), InputError);
  }
  SUBCASE("not there") {
    CHECK_THROWS_AS(read_checkpoint(folder / "none.pfc"), FileError);
  }
}

TEST_CASE("summary.json tells what was run and what came of it") {
  const TemporaryFolder folder;
  const Scene scene = small_scene(2, time_member(1, 0.1, 0.25));
  FreeFlight simulation(scene);
  simulation.fail_after = 4;
  SummaryWriter writer(folder / "summary.json", scene, 2);
  Runner runner(simulation);
  runner.add(writer);
  runner.run();
  const auto text = nlohmann::json::parse(read_file(folder / "summary.json"));
  CHECK(text["status"] == "failed");
  CHECK(text["failure"] == "particle 1 went away");
  CHECK(text["particles"] == 2);
  CHECK(text["totals"]["steps"] == 4);
  CHECK(text["totals"]["newton_iterations"] == 12);
  CHECK(text["totals"]["linear_iterations"] == 28);
  CHECK(text["wall_ms_by_phase"]["total"] == 6.0);
  CHECK(text["final"]["time"] == doctest::Approx(0.4));
  CHECK(text["scene_hash"] == scene_hash(scene));
  CHECK(parse_scene(text["scene"].dump(), "summary") == scene);
  CHECK(text["threads"] == 2);
  for (const char* key : {"version", "commit", "compiler", "flags", "cpu", "seed", "warnings", "wall_s"})
    CHECK(text.contains(key));
  CHECK(text["peak_memory_bytes"].get<double>() > 1e6);
}
