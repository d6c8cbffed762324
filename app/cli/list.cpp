// pushforward list: the registries, one name first on each line.
#include <cstdio>

#include "app/cli/commands.hpp"
#include "core/assets.hpp"
#include "core/materials/law.hpp"
#include "core/scene/choices.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

namespace {

struct Line {
  std::string name, about;
};

std::vector<Line> lines(std::span<const Choice> choices) {
  std::vector<Line> found;
  for (const Choice& choice : choices)
    found.push_back({std::string(choice.name), std::string(choice.label) + ": " + std::string(choice.help)});
  return found;
}

std::vector<Line> materials() {
  std::vector<Line> found;
  for (const LawInfo& law : laws()) {
    std::string keys;
    for (const LawParameter& parameter : law.parameters)
      keys += (keys.empty() ? "" : ", ") + std::string(parameter.key);
    found.push_back({std::string(law.name), std::string(law.about) + " (" + keys + ")"});
  }
  return found;
}

std::vector<Line> scenes() {
  std::vector<Line> found;
  for (const std::string& name : shipped_scenes()) {
    const Scene scene = load_scene(asset_path("scenes/" + name + ".json"));
    found.push_back({name, scene.about.empty() ? scene.name : scene.about});
  }
  return found;
}

struct Kind {
  const char* name;
  std::vector<Line> (*lines)();
};

constexpr Kind kinds[] = {
    {"materials", materials},
    {"bases", [] { return lines(basis_choices()); }},
    {"integrators", [] { return lines(integrator_choices()); }},
    {"transfers", [] { return lines(transfer_choices()); }},
    {"solvers", [] { return lines(solver_choices()); }},
    {"scenes", scenes},
};

}  // namespace

std::vector<std::string> list_kinds() {
  std::vector<std::string> names;
  for (const Kind& kind : kinds) names.emplace_back(kind.name);
  return names;
}

int list_names(const std::string& wanted) {
  for (const Kind& kind : kinds) {
    if (kind.name != wanted) continue;
    const std::vector<Line> found = kind.lines();
    std::size_t width = 0;
    for (const Line& line : found) width = std::max(width, line.name.size());
    for (const Line& line : found)
      std::printf("%-*s  %s\n", static_cast<int>(width), line.name.c_str(), line.about.c_str());
  }
  return exit_done;
}

}  // namespace pf::app
