// Exported files are read back by a reader that knows only the formats.
#include <doctest/doctest.h>

#include <cstring>
#include <sstream>

#include "core/output/export.hpp"
#include "fake_simulation.hpp"
#include "scene.hpp"

using namespace pf;
using namespace pf::test;

namespace {

std::string from_base64(const std::string& text) {
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned word = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    word = word << 6 | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(word >> bits & 255u);
  }
  return bytes;
}

// The array called `name` of a VTK XML file with inline base64 and 64-bit headers.
template <class T>
std::vector<T> vtk_array(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("Name=\"" + name + "\"");
  REQUIRE(at != std::string::npos);
  const std::size_t begin = text.find('>', at) + 1, end = text.find('<', begin);
  const std::string bytes = from_base64(text.substr(begin, end - begin));
  std::uint64_t length = 0;
  REQUIRE(bytes.size() >= sizeof length);
  std::memcpy(&length, bytes.data(), sizeof length);
  REQUIRE(bytes.size() == sizeof length + length);
  std::vector<T> values(length / sizeof(T));
  std::memcpy(values.data(), bytes.data() + sizeof length, length);
  return values;
}

struct Exported {
  TemporaryFolder folder;
  explicit Exported(const char* format) {
    FreeFlight simulation(small_scene(2, time_member(1, 0.5, 0.5)));
    Exporter exporter(*find_export_format(format), folder.path());
    Runner runner(simulation);
    runner.add(exporter);
    runner.run();
  }
};

}  // namespace

TEST_CASE("vtk: particles with their fields, one file a frame, and an index with the times") {
  const Exported out("vtk");
  const std::string text = read_file(out.folder / "particles_000002.vtp");
  CHECK(text.find("NumberOfPoints=\"2\"") != std::string::npos);
  CHECK(vtk_array<double>(text, "TimeValue") == std::vector<double>{1});
  CHECK(vtk_array<double>(text, "Points") == std::vector<double>{1, 2, 0, 2, 2, 0});
  CHECK(vtk_array<std::uint32_t>(text, "id") == std::vector<std::uint32_t>{0, 1});
  CHECK(vtk_array<double>(text, "J") == std::vector<double>{2, 2});
  CHECK(vtk_array<double>(text, "F") == std::vector<double>{2, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 0, 1, 0, 0, 0, 1});
  CHECK(vtk_array<double>(text, "pressure")[0] == doctest::Approx(-2));  // -(1 + 2 + 3)/3
  // Deviator diag(-1, 0, 1), shears 4, 5, 6: sqrt(3/2 (2 + 2 (16 + 25 + 36))).
  CHECK(vtk_array<double>(text, "von_mises")[0] == doctest::Approx(std::sqrt(1.5 * 156)));
  CHECK(vtk_array<std::int64_t>(text, "offsets") == std::vector<std::int64_t>{1, 2});
  const std::string index = read_file(out.folder / "particles.pvd");
  for (const char* line : {"timestep=\"0\" part=\"0\" file=\"particles_000000.vtp\"",
                           "timestep=\"0.5\" part=\"0\" file=\"particles_000001.vtp\"",
                           "timestep=\"1\" part=\"0\" file=\"particles_000002.vtp\""})
    CHECK(index.find(line) != std::string::npos);
}

TEST_CASE("vtk: the index of a continued run lists what is there") {
  const TemporaryFolder folder;
  Exporter exporter(*find_export_format("vtk"), folder.path(), {{0, 0}, {1, 0.5}, {2, 0.7}});
  FreeFlight simulation(small_scene(2, time_member(1, 0.5, 0.5)));
  exporter.on_frame(simulation, 2);
  const std::string index = read_file(folder / "particles.pvd");
  CHECK(index.find("timestep=\"0.5\" part=\"0\" file=\"particles_000001.vtp\"") != std::string::npos);
  CHECK(index.find("timestep=\"0\" part=\"0\" file=\"particles_000002.vtp\"") != std::string::npos);
  CHECK(index.find("0.7") == std::string::npos);
}

TEST_CASE("vtk: the active grid has a cell wherever all corners are active") {
  const Exported out("vtk");
  const std::string text = read_file(out.folder / "grid_000001.vtu");
  CHECK(vtk_array<double>(text, "Points") ==
        std::vector<double>{-0.5, 0, 0, 0, 0, 0, 0.5, 0, 0, -0.5, 0.5, 0, 0, 0.5, 0, 0.5, 0.5, 0});
  CHECK(vtk_array<std::int64_t>(text, "connectivity") == std::vector<std::int64_t>{0, 1, 4, 3, 1, 2, 5, 4});
  CHECK(vtk_array<std::int64_t>(text, "offsets") == std::vector<std::int64_t>{4, 8});
  CHECK(vtk_array<std::uint8_t>(text, "types") == std::vector<std::uint8_t>{9, 9});
  CHECK(vtk_array<double>(text, "velocity").size() == 18);
  CHECK(read_file(out.folder / "grid_000000.vtu").find("NumberOfPoints=\"0\"") != std::string::npos);
}

TEST_CASE("ply: the header's properties account for every byte") {
  const Exported out("ply");
  const std::string text = read_file(out.folder / "particles_000001.ply");
  const std::size_t end = text.find("end_header\n") + std::strlen("end_header\n");
  std::istringstream header(text.substr(0, end));
  std::size_t bytes = 0, vertices = 0;
  for (std::string word, type; header >> word;) {
    if (word == "vertex") header >> vertices;
    if (word != "property") continue;
    header >> type;
    bytes += type == "double" ? 8 : 4;
  }
  CHECK(vertices == 2);
  CHECK(text.size() - end == vertices * bytes);
  double x[3];
  std::memcpy(x, text.data() + end, sizeof x);
  CHECK(x[0] == 0.5);
  CHECK(x[1] == 1.0);
}

TEST_CASE("csv: named columns with units, a row a particle") {
  const Exported out("csv");
  std::istringstream text(read_file(out.folder / "particles_000001.csv"));
  std::string header, first;
  std::getline(text, header);
  std::getline(text, first);
  CHECK(header.starts_with("x [m],y [m],z [m],id,body,material,mass [kg],volume [m^3],X_x [m],X_y [m],X_z [m],"));
  CHECK(first.starts_with("0.5,1,0,0,0,0,2,0.5,0,0,0,1,2,0,"));
  CHECK(std::count(header.begin(), header.end(), ',') == std::count(first.begin(), first.end(), ','));
}

TEST_CASE("no format ever writes NaN") {
  ParticleState state;
  state.v = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  state.energy_density = std::numeric_limits<double>::infinity();
  const ParticleTable table = particle_table({state}, 2);
  for (const Column& column : table.columns)
    for (const double value : column.values) CHECK(std::isfinite(value));
  CHECK(csv_particles(table, 0).find("nan") == std::string::npos);
}
