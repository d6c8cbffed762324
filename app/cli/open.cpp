// pushforward [SCENE]: the app.
#include <cstdio>

#include "app/cli/commands.hpp"
#include "app/window.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

int open_app(const std::string& scene, const std::vector<std::string>& sets) {
  constexpr const char* welcome = "welcome";
  constexpr const char* headless_folder = "out/welcome";
  const std::filesystem::path file = find_scene(scene.empty() ? welcome : scene);
  const std::vector<Edit> edits = parse_sets(sets);
  const Scene checked = load_scene(file, edits);
  const std::string problem = open_window(checked, file, {.loop = scene.empty()});
  if (problem.empty()) return exit_done;
  std::fprintf(stderr, "No window can be opened: %s.\n", problem.c_str());
  if (!scene.empty()) {
    std::fprintf(stderr, "To run it without one: pushforward run %s --images --out DIR\n", scene.c_str());
    return exit_file_error;
  }
  std::fprintf(stderr, "Running the welcome scene without one; its pictures go to %s/images.\n", headless_folder);
  RunOptions options;
  options.scene = welcome;
  options.sets = sets;
  options.out = headless_folder;
  options.images = PictureSize{};
  const int status = run_scene(options);
  if (status == exit_done)
    std::fprintf(stderr, "The pictures are in %s\n",
                 std::filesystem::absolute(std::filesystem::path(headless_folder) / "images").c_str());
  return status;
}

}  // namespace pf::app
