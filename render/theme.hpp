// The colours of a picture: everything but the colour map.
#pragma once

#include "core/charts/painter.hpp"

namespace pf {

struct RenderTheme {
  Color background_top, background_bottom;
  Color lattice;                         ///< grid lines of the background
  Color cell;                            ///< tint of active cells
  Color node;                            ///< active node
  Color node_fixed;                      ///< node held by a constraint
  Color node_contact;                    ///< node in contact
  Color arrow;                           ///< node velocity
  Color arrow_rim;                       ///< sets arrows and bent lines off from the particles
  Color bent_grid;                       ///< images of the grid lines under phi^
  Color solid, solid_hatch, solid_edge;  ///< boundaries
  Color solid_3d, ground, ground_line;   ///< boundaries in 3D
  Color constraint, load;                ///< regions
  Color silhouette;                      ///< thin line around bodies in 2D, opaque
  Color inverted;                        ///< particles with J <= 0
  Color selection;
  Color text, text_muted;
  Color panel;            ///< behind the colour bar, translucent
  float outline = 0.25f;  ///< how much a zoomed-in particle's rim is darkened

  static RenderTheme dark();
  static RenderTheme light();
  bool operator==(const RenderTheme&) const = default;
};

}  // namespace pf
