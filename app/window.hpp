// The interactive workbench: opens the window and stays in it until the user quits.
#pragma once

#include <filesystem>
#include <string>

#include "core/scene/scene.hpp"

namespace pf::app {

struct WindowOptions {
  int threads = 0;    ///< of the simulation; 0: all hardware threads
  bool run = true;    ///< start running at once
  bool loop = false;  ///< begin again at time.end (the welcome scene); else pause there
};

/// Shows `scene`, which came from `file` (empty: never saved), until the user closes the window. Returns nothing
/// then, or at once why no window can be opened here, in the user's words ("X11: The DISPLAY environment variable is
/// missing"): a display without OpenGL 3.3 counts as none.
std::string open_window(const Scene& scene, const std::filesystem::path& file, const WindowOptions& options = {});

/// Opens and closes a hidden window: empty when that can be done, else why not.
std::string display_problem();

}  // namespace pf::app
