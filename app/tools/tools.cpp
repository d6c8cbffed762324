#include "app/tools/edit_tools.hpp"
#include "app/tools/grab.hpp"
#include "app/tools/tool.hpp"

namespace pf::app {

const std::vector<ToolInfo>& tools() {
  static const std::vector<ToolInfo> table{
      {"grab", "Grab",
       "Drag pulls the material, the wheel sets how much of it; a click selects a particle, with Ctrl a node.",
       make_grab_tool},
      {"pin", "Pin",
       "A click holds the material there fast, a click on a pin lets it go; hold the button and turn the wheel for a "
       "larger one.",
       make_pin_tool},
      {"push", "Push",
       "Drag: a ball as hard as a wall follows the mouse and pushes the material aside; the wheel sets the size of the "
       "next ball.",
       make_push_tool},
      {"cut", "Cut",
       "Drag: the material under the brush is taken away, in 3D all that is behind the mouse. Undo puts it back; the "
       "energy balance says what went with it.",
       make_cut_tool},
      {"paint", "Paint",
       "Drag: the material under the brush becomes another one of the scene, deformed as it is; in 3D as deep as the "
       "brush is wide.",
       make_paint_tool},
      {"probe", "Probe",
       "A click on the material places a probe that goes along with it, one on a probe selects it; their curves are in "
       "the drawer.",
       make_probe_tool},
      {"arrange", "Arrange",
       "Selects bodies, walls, supports and loads; drag moves them, the round knob turns, the square one scales. In "
       "half "
       "cells and steps of 15\u00b0; with Ctrl freely.",
       make_arrange_tool},
      {"box", "Box", "Drag from corner to corner: the body enters the running simulation, of the selected material.",
       make_box_tool},
      {"ball", "Ball",
       "Drag from the centre outwards: the body enters the running simulation, of the selected material.",
       make_ball_tool},
      {"polygon", "Polygon", "Click the corners; a click on the first one closes it. Esc forgets them.",
       make_polygon_tool, true},
  };
  return table;
}

}  // namespace pf::app
