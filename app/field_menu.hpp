// Which fields a scene has, and the menus that choose among them.
#pragma once

#include "app/context.hpp"

namespace pf::app {

/// No error without an exact motion, no materials where there is one, no third components in 2D.
bool offers(const Scene& scene, const FieldInfo& field);

/// Items of a menu: those used most with their keys, the others in a menu a group.
void draw_field_menu(AppContext& context);
/// The same as a box in a panel, the groups under headings.
void draw_field_box(AppContext& context);
/// Check marks for what the ends of the colour map mean: menu items, or boxes in a panel.
void draw_color_scale_items(AppContext& context);
void draw_color_scale_boxes(AppContext& context);

}  // namespace pf::app
