// How charts look: colours with checked contrast, and sizes from which every spacing follows.
#pragma once

#include <array>

#include "core/charts/painter.hpp"

namespace pf {

struct ChartTheme {
  Color surface;                ///< behind the chart; alpha 0 leaves what is there
  Color text;                   ///< contrast with the surface at least 7:1
  Color muted;                  ///< tick labels, notes; at least 4.5:1
  Color grid, minor_grid;       ///< quiet lines
  Color axis;                   ///< the base lines
  Color pinned;                 ///< curves of earlier runs; at least 3:1
  Color panel;                  ///< behind legends and tooltips
  std::array<Color, 8> series;  ///< at least 3:1 with the surface, distinct to colour-blind eyes
  float font_size = 13;         ///< of tick labels and legend [pixels]; titles derive from it
  float line_width = 1.8f;      ///< [pixels]
};

ChartTheme light_theme(float font_size = 13);
ChartTheme dark_theme(float font_size = 13);

}  // namespace pf
