#include "app/window.hpp"

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

std::string open_window(const Scene& scene, const std::filesystem::path& file, const WindowOptions& options) {
  Workbench::Setup setup;
  setup.threads = options.threads;
  setup.run = options.run;
  setup.at_end = options.loop ? AtEnd::loop : AtEnd::pause;
  try {
    Workbench workbench(scene, file, setup);
    while (workbench.frame()) {
    }
    return {};
  } catch (const DisplayError& error) {
    return error.what();
  }
}

}  // namespace pf::app
