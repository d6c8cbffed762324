#include "core/assets.hpp"

#include <cstdlib>
#include <string>

#include "core/scene/scene_io.hpp"

#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

namespace pf {
namespace {

namespace fs = std::filesystem;

/// The folder of the running executable; empty where the system does not tell.
fs::path executable_folder() {
  std::error_code ignored;
#ifdef __APPLE__
  char buffer[4096];
  uint32_t size = sizeof buffer;
  if (_NSGetExecutablePath(buffer, &size) != 0) return {};
  return fs::weakly_canonical(buffer, ignored).parent_path();
#else
  return fs::read_symlink("/proc/self/exe", ignored).parent_path();
#endif
}

}  // namespace

std::vector<fs::path> asset_roots() {
  std::vector<fs::path> roots;
  if (const char* chosen = std::getenv("PUSHFORWARD_ASSETS"); chosen && *chosen) roots.emplace_back(chosen);
  if (const fs::path folder = executable_folder(); !folder.empty()) {
    roots.push_back(folder.parent_path() / "share" / "pushforward");
    roots.push_back(folder / "assets");
    roots.push_back(folder.parent_path() / "assets");
  }
  roots.emplace_back(PUSHFORWARD_SOURCE_ASSETS);
  return roots;
}

fs::path asset_path(std::string_view relative) {
  std::vector<fs::path> candidates;
  for (const fs::path& root : asset_roots()) candidates.push_back(root / relative);
  constexpr std::string_view shaders = "shaders/";
  if (relative.starts_with(shaders)) {
    candidates.push_back(fs::path(PUSHFORWARD_SOURCE_SHADERS) / relative.substr(shaders.size()));
  }
  std::string tried;
  for (const fs::path& candidate : candidates) {
    std::error_code ignored;
    if (fs::exists(candidate, ignored)) return candidate;
    tried += "\n  " + candidate.string();
  }
  throw FileError("the program's own file \"" + std::string(relative) +
                  "\" is missing; set PUSHFORWARD_ASSETS to the folder that holds it. Tried:" + tried);
}

}  // namespace pf
