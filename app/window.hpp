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

/// Empty when a window can be opened here, else why not, in the user's words ("no display: DISPLAY is not set").
/// Opens and closes a hidden window to know, so that a display without OpenGL 3.3 counts as none.
std::string display_problem();

/// Shows `scene`, which came from `file` (empty: never saved). Returns the exit status once the window is closed:
/// 0, or 4 when no window could be opened.
int open_window(const Scene& scene, const std::filesystem::path& file, const WindowOptions& options = {});

}  // namespace pf::app
