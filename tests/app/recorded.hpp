// What a record left: its files, in order, and the times written in its pictures.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "core/charts/image.hpp"
#include "tests/app/stage.hpp"

namespace pf::app::staged {

/// Ten steps.
inline Scene short_fall() {
  Scene scene = small();
  scene.time.end = 0.05;
  return scene;
}

inline std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// [s]; negative where the picture has none.
inline double time_of(const fs::path& png) {
  for (const auto& [key, text] : read_png_text(png))
    if (key == "Time") return std::atof(text.c_str());
  return -1;
}

}  // namespace pf::app::staged
