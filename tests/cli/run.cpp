// pushforward run: what it writes and how it ends.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/charts/image.hpp"
#include "program.hpp"

using namespace pf::test;
namespace fs = std::filesystem;

namespace {

// stats.csv without its column of wall times, the only one that may differ between runs.
std::string without_wall(const fs::path& file) {
  std::istringstream text(pf::read_file(file));
  std::string line, kept;
  std::size_t wall = 0;
  while (std::getline(text, line)) {
    std::istringstream cells(line);
    std::size_t column = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++column) {
      if (cell == "wall_ms") wall = column;
      if (wall == 0 || column != wall) kept += cell + ',';
    }
    kept += '\n';
  }
  return kept;
}

nlohmann::json summary(const fs::path& folder) {
  return nlohmann::json::parse(pf::read_file(folder / "summary.json"));
}

long rows(const fs::path& file) {
  const std::string text = pf::read_file(file);
  return std::count(text.begin(), text.end(), '\n');
}

}  // namespace

TEST_CASE("without --out a run prints one line; with --quiet none") {
  const Workplace here;
  here.put("scene.json", falling_block);
  const Outcome outcome = here.run("run scene.json");
  CHECK(outcome.status == 0);
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 1);
  CHECK(outcome.out.find("Block: done at t = 0.05 s after 5 steps of 16 particles") == 0);
  const Outcome quiet = here.run("run scene.json --quiet");
  CHECK(quiet.status == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
}

TEST_CASE("run --out writes every file that was asked for") {
  const Workplace here;
  here.put("scene.json", falling_block);
  const Outcome outcome = here.run(
      "run scene.json --out o --export=vtk --checkpoint-every 0.02 --set '/probes/-={\"name\":\"tip\",\"at\":[1,1]}'");
  CHECK(outcome.status == 0);
  CAPTURE(outcome.err);
  CHECK(rows(here / "o/stats.csv") == 7);
  CHECK(rows(here / "o/probes.csv") == 7);
  CHECK(summary(here / "o")["status"] == "done");
  CHECK(summary(here / "o")["particles"] == 16);
  for (const char* file : {"export/particles_000000.vtp", "export/particles_000003.vtp", "export/grid_000003.vtu",
                           "export/particles.pvd", "checkpoints/000000.pfc", "checkpoints/000003.pfc"}) {
    CAPTURE(file);
    CHECK(fs::exists(here / "o" / file));
  }
  CHECK_FALSE(fs::exists(here / "o/export/particles_000004.vtp"));
}

TEST_CASE("--energy writes the account of the energy, and changes no byte of the run") {
  const Workplace here;
  here.put("scene.json", falling_block);
  REQUIRE(here.run("run scene.json --out plain").status == 0);
  CHECK_FALSE(fs::exists(here / "plain/energy.csv"));
  REQUIRE(here.run("run scene.json --out counted --energy").status == 0);
  CHECK(rows(here / "counted/energy.csv") == 7);
  CHECK(pf::read_file(here / "counted/energy.csv").find(",time_integration,") != std::string::npos);
  CHECK(summary(here / "counted")["final"] == summary(here / "plain")["final"]);
  CHECK(here.run("run scene.json --energy").status == 2);
  REQUIRE(here.run("run scene.json --out counted").status == 0);  // ours of the run before is gone
  CHECK_FALSE(fs::exists(here / "counted/energy.csv"));
}

TEST_CASE("a free block falls with g: momentum after t is m g t") {
  const Workplace here;
  here.put("scene.json", falling_block);
  REQUIRE(here.run("run scene.json --out o --set /solver/newton_tolerance=1e-10").status == 0);
  const auto final = summary(here / "o")["final"];
  CHECK(final["momentum"][1].get<double>() == doctest::Approx(-250 * 10 * 0.05).epsilon(1e-9));
  CHECK(final["kinetic_energy"].get<double>() == doctest::Approx(0.5 * 250 * 0.25).epsilon(1e-6));
}

TEST_CASE("the same bytes in stats.csv for 1 and 2 threads, and for a run that was continued") {
  const Workplace here;
  here.put("scene.json", falling_block);
  REQUIRE(here.run("run scene.json --out one --threads 1").status == 0);
  REQUIRE(here.run("run scene.json --out two --threads 2").status == 0);
  CHECK(without_wall(here / "one/stats.csv") == without_wall(here / "two/stats.csv"));
  REQUIRE(here.run("run scene.json --out parts --steps 3 --checkpoint-every 0.02").status == 0);
  CHECK(rows(here / "parts/stats.csv") == 5);
  const Outcome resumed = here.run("run scene.json --out parts --resume parts/checkpoints/000001.pfc");
  CAPTURE(resumed.err);
  CHECK(resumed.status == 0);
  CHECK(without_wall(here / "one/stats.csv") == without_wall(here / "parts/stats.csv"));
  const Outcome other = here.run("run scene.json --resume parts/checkpoints/000001.pfc --set /time/step=0.02");
  CHECK(other.status == 2);
  CHECK(other.err.find("another scene") != std::string::npos);
}

TEST_CASE(
    "adaptive runs: the same bytes for 1 and 2 threads and when continued, and they compare as equal to themselves") {
  const Workplace here;
  here.put("scene.json", falling_block);
  const std::string run = "run scene.json --set /time/control=adaptive --set /time/tolerance=0.3 --until 0.3 ";
  REQUIRE(here.run(run + "--out one --threads 1").status == 0);
  REQUIRE(here.run(run + "--out two --threads 2").status == 0);
  CHECK(without_wall(here / "one/stats.csv") == without_wall(here / "two/stats.csv"));
  REQUIRE(here.run(run + "--out parts --steps 5 --checkpoint-every 0.02").status == 0);
  const Outcome resumed = here.run(run + "--out parts --resume parts/checkpoints/000001.pfc");
  CAPTURE(resumed.err);
  CHECK(resumed.status == 0);
  CHECK(without_wall(here / "one/stats.csv") == without_wall(here / "parts/stats.csv"));
  CHECK(here.run("compare one two").status == 0);
}

TEST_CASE("--until replaces the end, --steps counts; the first reached wins") {
  const Workplace here;
  here.put("scene.json", falling_block);
  const auto end = [&here](const std::string& options) {
    REQUIRE(here.run("run scene.json --out o " + options).status == 0);
    return summary(here / "o")["final"]["time"].get<double>();
  };
  CHECK(end("--until 0.12") == doctest::Approx(0.12));
  CHECK(end("--until 0.015") == doctest::Approx(0.015));
  CHECK(end("--steps 2") == doctest::Approx(0.02));
  CHECK(end("--until 0.03 --steps 200") == doctest::Approx(0.03));
}

TEST_CASE("Ctrl+C and SIGTERM: exit status 130, outputs closed") {
  const Workplace here;
  here.put("scene.json", falling_block);
  for (const char* signal : {"INT", "TERM"}) {
    CAPTURE(signal);
    const Outcome outcome =
        here.run("run scene.json --out o --until 1e6", std::string("timeout --foreground -s ") + signal + " 1");
    // timeout reports 124 unless told to hand on the status.
    CHECK(outcome.status == 124);
    CHECK(summary(here / "o")["status"] == "interrupted");
    CHECK(pf::read_file(here / "o/stats.csv").ends_with("\n"));
    const Outcome kept = here.run("run scene.json --out o --until 1e6",
                                  std::string("timeout --foreground --preserve-status -s ") + signal + " 1");
    CHECK(kept.status == 130);
  }
}

TEST_CASE("--images draws a picture a frame, with its origin in the file") {
  const Workplace here;
  here.put("scene.json", falling_block);
  const Outcome outcome = here.run("run scene.json --out o --images=320x200");
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  for (const char* file : {"000000.png", "000001.png", "000002.png", "000003.png"}) {
    const pf::Image image = pf::read_image(here / "o/images" / file);
    CHECK(image.width == 320);
    CHECK(image.height == 200);
  }
  CHECK_FALSE(fs::exists(here / "o/images/000004.png"));
  std::string text;
  for (const auto& [key, value] : pf::read_png_text(here / "o/images/000001.png")) text += key + "=" + value + "\n";
  const auto run = summary(here / "o");
  CHECK(text.find("Software=pushforward 0.1.0") != std::string::npos);
  CHECK(text.find("Commit=" + run["commit"].get<std::string>()) != std::string::npos);
  CHECK(text.find("Scene hash=" + run["scene_hash"].get<std::string>()) != std::string::npos);
}

TEST_CASE("a full disk ends a run with exit status 4 and the file's name") {
  if (!fs::exists("/dev/full")) return;
  const Workplace here;
  here.put("scene.json", falling_block);
  fs::create_directory(here / "o");
  fs::create_symlink("/dev/full", here / "o/stats.csv");
  const Outcome outcome = here.run("run scene.json --out o");
  CHECK(outcome.status == 4);
  CHECK(outcome.err.find("stats.csv") != std::string::npos);
  CHECK(here.run("schema >/dev/full; exit $?").status == 4);
}
