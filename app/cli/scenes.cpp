// Which scene is meant, and what is wrong with it: scene names, --set, check, schema.
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "app/cli/commands.hpp"
#include "core/assets.hpp"
#include "core/params/nearest.hpp"
#include "core/scene/scene_io.hpp"
#include "core/simulation.hpp"

namespace pf::app {

namespace {

namespace fs = std::filesystem;

}  // namespace

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(asset_path("scenes"), error))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_scene(const std::string& name) {
  std::error_code ignored;
  if (fs::exists(name, ignored)) return name;
  const std::vector<std::string> shipped = shipped_scenes();
  if (std::find(shipped.begin(), shipped.end(), name) != shipped.end()) return asset_path("scenes/" + name + ".json");
  const std::string near = nearest_name(fs::path(name).stem().string(), shipped);
  throw FileError(name + ": there is no such file" +
                  (near.empty() ? "" : "; did you mean the shipped scene " + near + "?"));
}

std::vector<Edit> parse_sets(const std::vector<std::string>& sets) {
  std::vector<Edit> edits;
  edits.reserve(sets.size());
  for (const std::string& set : sets) edits.push_back(parse_set(set));
  return edits;
}

int check_scenes(const std::vector<std::string>& files) {
  int status = exit_done;
  for (const std::string& name : files) {
    try {
      const fs::path file = find_scene(name);
      make_simulation(load_scene(file), {1, file.string()});  // may be well-formed and impossible to build
      std::printf("%s: valid\n", file.string().c_str());
    } catch (const InputError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      if (status != exit_file_error) status = exit_bad_input;
    } catch (const FileError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      status = exit_file_error;
    }
  }
  return status;
}

int print_schema() {
  std::cout << scene_schema().dump(2) << std::endl;
  return exit_done;
}

}  // namespace pf::app
