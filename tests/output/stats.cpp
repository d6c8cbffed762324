#include "core/output/stats.hpp"

#include <doctest/doctest.h>

#include <sstream>

#include "core/output/run_folder.hpp"
#include "fake_simulation.hpp"
#include "scene.hpp"

using namespace pf;
using namespace pf::test;

namespace {

std::vector<std::string> lines(const std::filesystem::path& file) {
  std::istringstream text(read_file(file));
  std::vector<std::string> found;
  for (std::string line; std::getline(text, line);) found.push_back(line);
  return found;
}

template <class Writer>
std::vector<std::string> written(const Scene& scene) {
  const TemporaryFolder folder;
  FreeFlight simulation(scene);
  Writer writer(folder / "file.csv", scene);
  Runner runner(simulation);
  runner.add(writer);
  runner.run();
  return lines(folder / "file.csv");
}

const std::string exact = R"(, "exact": {"position": ["X + t", "Y + 2*t"]})";

}  // namespace

TEST_CASE("stats.csv in 2D has the contract's columns, the initial state and a row each step") {
  const auto rows = written<StatsWriter>(small_scene(2, time_member(0.2, 0.1, 0.1)));
  REQUIRE(rows.size() == 4);
  CHECK(rows[0] ==
        "step,time,dt,newton_iterations,linear_iterations,residual,kinetic_energy,elastic_energy,potential_energy,"
        "total_energy,momentum_x,momentum_y,angular_momentum_z,min_J,max_J,active_nodes,cfl,wall_ms,stable_step,"
        "converged");
  CHECK(rows[1] ==
        "0,0,0,0,0,0.10000000000000001,5,0.33333333333333331,-0,5.333333333333333,4,8,-3,0.5,2,6,0.25,1.5,0.125,1");
  CHECK(rows[3].ends_with(",,0"));  // a residual of 0.1
  CHECK(rows[3].starts_with("2,0.20000000000000001,0.10000000000000001,3,7,"));
}

TEST_CASE("stats.csv in 3D has the third components, and errors where the scene has an exact motion") {
  const auto rows = written<StatsWriter>(small_scene(3, time_member(0.1, 0.1, 0.1)));
  CHECK(rows[0] ==
        "step,time,dt,newton_iterations,linear_iterations,residual,kinetic_energy,elastic_energy,potential_energy,"
        "total_energy,momentum_x,momentum_y,momentum_z,angular_momentum_x,angular_momentum_y,angular_momentum_z,"
        "min_J,max_J,active_nodes,cfl,wall_ms,stable_step,converged");
  CHECK(rows[1].find(",4,8,12,-1,-2,-3,0.5,2,6,") != std::string::npos);
  const auto with_errors = written<StatsWriter>(small_scene(2, time_member(0.1, 0.1, 0.1) + exact));
  CHECK(with_errors[0].ends_with(",cfl,wall_ms,error_l2,error_max,error_velocity_l2,error_F_l2,stable_step,converged"));
  CHECK(with_errors[1].ends_with(",1.5,0.01,0.02,0.029999999999999999,0.040000000000000001,0.125,1"));
}

TEST_CASE("stats.csv says what adaptive steps chose and why, behind all other columns") {
  const std::string adaptive = R"(, "time": {"end": 0.2, "step": 0.1, "control": "adaptive"})";
  const std::string added = ",integrator,limited_by,error_rate,explicit_limit,implicit_cost,explicit_cost,given_up";
  const auto header = [](int dimension, bool with_errors) {
    const std::string fixed = stats_header({dimension, with_errors});
    return fixed.substr(0, fixed.find(",stable_step"));
  };
  CHECK(stats_header({2, false, true}) == header(2, false) + added + ",stable_step,converged");
  CHECK(stats_header({3, true, true}) == header(3, true) + added + ",stable_step,converged");
  CHECK(written<StatsWriter>(small_scene(2, adaptive))[0] == stats_header({2, false, true}));
  StepReport report;
  const auto row = [&](bool with_control) { return stats_row(report, {2, false, with_control}, 0.25, false); };
  const std::string last = ",0.25,0";
  const auto without = [&] { return row(false).substr(0, row(false).size() - last.size()); };
  CHECK(row(true) == without() + ",,,0,0,0,0,0" + last);
  report.dt = 0.1;
  report.control = {.adaptive = true,
                    .implicit = false,
                    .limited_by = StepLimit::stability,
                    .error_rate = 0.5,
                    .explicit_limit = 0.25,
                    .implicit_cost = 8,
                    .explicit_cost = 2,
                    .given_up = 1};
  CHECK(row(true) == without() + ",explicit,stability,0.5,0.25,8,2,1" + last);
}

TEST_CASE("probes.csv has a row each probe and state, and quotes names that need it") {
  const std::string probes = R"(, "probes": [{"name": "tip, upper", "at": [1, 1]}])";
  const auto rows = written<ProbesWriter>(small_scene(2, time_member(0.5, 0.5, 0.5) + probes));
  CHECK(rows == std::vector<std::string>{"time,probe,x,y,vx,vy,sxx,syy,szz,sxy", "0,\"tip, upper\",0,0,1,2,1,2,3,4",
                                         "0.5,\"tip, upper\",0.5,1,1,2,1,2,3,4"});
  const std::string solid = R"(, "probes": [{"name": "tip", "at": [1, 1, 1]}])";
  const auto spatial = written<ProbesWriter>(small_scene(3, time_member(0.5, 0.5, 0.5) + solid));
  CHECK(spatial[0] == "time,probe,x,y,z,vx,vy,vz,sxx,syy,szz,sxy,syz,sxz");
  CHECK(spatial[2] == "0.5,tip,0.5,1,1.5,1,2,3,1,2,3,4,5,6");
}

TEST_CASE("17 digits give every double back") {
  for (const double value : {0.1, 1.0 / 3, -2.5e-308, 1.7976931348623157e308, 123456789.123456789}) {
    std::string text;
    append_number(text, value);
    CHECK(std::strtod(text.c_str(), nullptr) == value);
  }
}

TEST_CASE("a folder is used again: our old files go, foreign ones stay") {
  const TemporaryFolder root;
  const RunFolder folder{root.path()};
  const Scene scene = small_scene();
  for (const auto& sub : {folder.images(), folder.exports(), folder.checkpoints()}) make_folder(sub);
  const auto put = [](const std::filesystem::path& file, const std::string& text = "x") {
    write_atomically(file, text);
  };
  put(folder.images() / "000007.png");
  put(folder.images() / "holiday.png");
  put(folder.exports() / "particles_000007.vtp");
  put(folder.exports() / "grid_000007.vtu");
  put(folder.checkpoints() / "000007.pfc");
  put(root / "notes.txt");

  SUBCASE("a folder that no run of ours has filled is left alone") {
    prepare_run_folder(folder, scene);
    CHECK(std::filesystem::exists(folder.images() / "000007.png"));
  }
  SUBCASE("one that has our stats.csv is cleared of ours") {
    put(folder.stats(), stats_header({2, false}) + "\n");
    prepare_run_folder(folder, scene);
    CHECK_FALSE(std::filesystem::exists(folder.images() / "000007.png"));
    CHECK_FALSE(std::filesystem::exists(folder.exports() / "particles_000007.vtp"));
    CHECK_FALSE(std::filesystem::exists(folder.exports() / "grid_000007.vtu"));
    CHECK_FALSE(std::filesystem::exists(folder.checkpoints() / "000007.pfc"));
  }
  CHECK(std::filesystem::exists(folder.images() / "holiday.png"));
  CHECK(std::filesystem::exists(root / "notes.txt"));
}

TEST_CASE("a disk that is full is an error that names the file") {
  if (!std::filesystem::exists("/dev/full")) return;
  OutputFile file("/dev/full");
  file.write("some text");
  CHECK_THROWS_WITH_AS(file.flush(), doctest::Contains("/dev/full"), FileError);
}
