#include "app/window.hpp"

#include <cstdio>

#include "app/workbench.hpp"

namespace pf::app {

std::string display_problem() {
  try {
    const GlfwWindow probe("Pushforward", {}, false);
    return {};
  } catch (const DisplayError& error) {
    return error.what();
  }
}

int open_window(const Scene& scene, const std::filesystem::path& file, const WindowOptions& options) {
  Workbench::Setup setup;
  setup.threads = options.threads;
  setup.run = options.run;
  setup.at_end = options.loop ? AtEnd::loop : AtEnd::pause;
  try {
    Workbench workbench(scene, file, setup);
    while (workbench.frame()) {
    }
    return 0;
  } catch (const DisplayError& error) {
    std::fprintf(stderr, "pushforward: %s\n", error.what());
    return 4;
  }
}

}  // namespace pf::app
