// Tools that change the scene: arrange what is there, draw bodies, pin, push, cut and paint them.
#pragma once

#include "app/tools/tool.hpp"

namespace pf::app {

std::unique_ptr<Tool> make_cut_tool();
std::unique_ptr<Tool> make_paint_tool();
std::unique_ptr<Tool> make_probe_tool();
std::unique_ptr<Tool> make_arrange_tool();
std::unique_ptr<Tool> make_pin_tool();
std::unique_ptr<Tool> make_push_tool();
std::unique_ptr<Tool> make_box_tool();
std::unique_ptr<Tool> make_ball_tool();
std::unique_ptr<Tool> make_polygon_tool();

}  // namespace pf::app
