// DESIGN's dependency rule, read off the #include lines: the right may include the left, siblings never each other.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Folders = std::set<std::string>;

const fs::path source = PUSHFORWARD_SOURCE;

// For each folder of core, the other folders of core that it may include. "" is core itself: types, snapshot,
// step_report, simulation, runner. A new folder needs a line here, and a reason.
const std::map<std::string, Folders> core_rule{
    {"params", {}},
    {"math", {"params"}},
    {"charts", {"params", "diagnostics"}},
    {"bases", {"params", "math"}},
    {"materials", {"params", "math"}},
    {"grid", {"params", "math", "bases"}},
    {"transfers", {"params", "math", "bases", "materials", "grid"}},
    {"energies", {"params", "math", "bases", "materials", "grid", "solvers"}},
    {"solvers", {"params", "math"}},
    {"control", {}},
    {"integrators", {"params", "math", "bases", "materials", "grid", "transfers", "energies", "solvers"}},
    {"scene",
     {"params", "math", "bases", "materials", "transfers", "solvers", "integrators", "control", "diagnostics"}},
    // The simulation itself, a template of the dimension: sees all that it is put together from.
    {"step",
     {"", "params", "math", "bases", "materials", "grid", "transfers", "energies", "solvers", "integrators", "control",
      "scene", "diagnostics"}},
    {"diagnostics", {"params", "math", "bases", "materials", "grid", "scene"}},
    {"output", {"", "params", "math", "materials", "scene", "diagnostics"}},
    // Measures the parts of a step by themselves, so it sees them all.
    {"bench",
     {"", "params", "math", "bases", "materials", "grid", "transfers", "energies", "solvers", "integrators", "scene",
      "diagnostics"}},
    {"studies", {"", "params", "math", "bases", "materials", "scene", "diagnostics", "charts", "output"}},
    // Tries things on whole simulations.
    {"advice", {"", "params", "bases", "integrators", "scene", "studies"}},
    {"lab", {"", "params", "math", "materials", "scene", "diagnostics", "charts", "output"}},
};
// Plain types at the top of core that every folder may include.
const Folders plain_headers{"core/types.hpp", "core/step_report.hpp", "core/build_info.hpp", "core/snapshot.hpp",
                            "core/files.hpp", "core/hash.hpp",        "core/assets.hpp",     "core/work_weights.hpp"};

std::vector<fs::path> sources(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
    const auto extension = entry.path().extension();
    if (entry.is_regular_file() && (extension == ".cpp" || extension == ".hpp")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> includes(const fs::path& file) {
  std::vector<std::string> found;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("#include")) continue;
    const auto begin = line.find_first_of("\"<"), end = line.find_last_of("\">");
    if (begin != std::string::npos && end > begin) found.push_back(line.substr(begin + 1, end - begin - 1));
  }
  return found;
}

std::string place(const fs::path& file) {
  return fs::relative(file, source).generic_string();
}

// "core/materials/hencky.cpp" -> "materials"; "core/simulation.hpp" -> "".
std::string core_folder(const std::string& path) {
  const std::string rest = path.substr(std::string("core/").size());
  const auto slash = rest.find('/');
  return slash == std::string::npos ? "" : rest.substr(0, slash);
}

bool is_graphics(const std::string& header) {
  for (const char* prefix : {"GL/", "GLFW/", "epoxy/", "glm/", "imgui", "EGL/", "backends/imgui"})
    if (header.starts_with(prefix)) return true;
  return false;
}

}  // namespace

TEST_CASE("core knows no window: no OpenGL, GLFW, ImGui, GLM, and nothing of render or app") {
  for (const auto& file : sources("core"))
    for (const auto& header : includes(file)) {
      CAPTURE(place(file));
      CAPTURE(header);
      CHECK_FALSE(is_graphics(header));
      CHECK_FALSE(header.starts_with("render/"));
      CHECK_FALSE(header.starts_with("app/"));
    }
}

TEST_CASE("folders of core include only what stands before them") {
  for (const auto& file : sources("core")) {
    const std::string folder = core_folder(place(file));
    if (folder.empty()) continue;  // simulation, runner: the top of core, may include every folder
    CAPTURE(place(file));
    REQUIRE_MESSAGE(core_rule.contains(folder), "a new folder of core needs a line in this test's table");
    for (const auto& header : includes(file)) {
      if (!header.starts_with("core/") || plain_headers.contains(header)) continue;
      const std::string other = core_folder(header);
      CAPTURE(header);
      CHECK((other == folder || core_rule.at(folder).contains(other)));
    }
  }
}

TEST_CASE("render sees snapshots, fields, charts and plain types, never the simulation") {
  if (!fs::exists(source / "render")) return;
  for (const auto& file : sources("render"))
    for (const auto& header : includes(file)) {
      CAPTURE(place(file));
      CAPTURE(header);
      if (header.starts_with("core/"))
        CHECK((plain_headers.contains(header) || header.starts_with("core/charts/") ||
               header.starts_with("core/diagnostics/fields") || header == "core/params/problem.hpp"));
      CHECK_FALSE(header.starts_with("app/"));
    }
}

TEST_CASE("every header can be included twice") {
  for (const char* folder : {"core", "render", "app"}) {
    if (!fs::exists(source / folder)) continue;
    for (const auto& file : sources(folder)) {
      if (file.extension() != ".hpp") continue;
      std::ifstream in(file);
      const std::string text((std::istreambuf_iterator<char>(in)), {});
      CAPTURE(place(file));
      CHECK(text.find("#pragma once") != std::string::npos);
    }
  }
}

TEST_CASE("no source file has more than 400 lines") {
  for (const char* folder : {"core", "render", "app", "tests"}) {
    if (!fs::exists(source / folder)) continue;
    for (const auto& file : sources(folder)) {
      std::ifstream in(file);
      long lines = 0;
      for (std::string line; std::getline(in, line);) ++lines;
      CAPTURE(place(file));
      CHECK(lines <= 400);
    }
  }
}
