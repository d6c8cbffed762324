// View: what is drawn and how. Nothing here touches the physics.
#include <imgui.h>

#include <cmath>

#include "app/field_menu.hpp"
#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "render/color_range.hpp"

namespace pf::app {

namespace {

/// A number of the view with the same control as the scene's settings have.
bool view_number(PanelMemory& m, const std::string& key, const Setting& about, double& value, double usual) {
  ImGui::PushID(key.c_str());
  const NumberControl control{m.typing, about, key, about.label, about.help, usual, false, {}};
  const auto to = number_control(control, value);
  if (to) value = *to;
  if (m.typing.refused_key == key) warning(m.typing.refusal);
  ImGui::PopID();
  gap(0.5F);
  return to.has_value();
}

Setting view_setting(std::string label, std::string unit, double low, double high, std::string help) {
  Setting s;
  s.label = std::move(label);
  s.unit = std::move(unit);
  s.slider_min = low;
  s.slider_max = high;
  s.applies = Applies::view;
  s.help = std::move(help);
  return s;
}

void choose_field(AppContext& context) {
  ImGui::AlignTextToFramePadding();
  text_unformatted("Colour by");
  draw_field_box(context);
}

/// What the colour bar shows at the moment, for as long as the user types nothing else.
void lock_at_present(ViewState& view, const Snapshot& snapshot) {
  const std::vector<float>& values = snapshot.field[static_cast<std::size_t>(view.field)];
  if (values.empty()) return;
  const FieldInfo& info = field_info(view.field);
  const ValueRange now = percentile_range(values, info, color_scale(info, view.log_colors, view.symmetric));
  view.range_min = rounded(now.min, 3);
  view.range_max = rounded(now.max, 3);
}

void choose_range(PanelMemory& m, AppContext& context) {
  ViewState& view = context.view;
  const FieldInfo& info = field_info(view.field);
  if (info.scale == FieldScale::categorical) return;
  draw_color_scale_boxes(context);
  if (checkbox("lock", "Lock the colour range", &view.lock_range) && view.lock_range && context.snapshot)
    lock_at_present(view, *context.snapshot);
  tooltip("Keeps the ends of the colour bar while the values change, so that pictures can be compared.");
  if (!view.lock_range) return;
  // No slider: the ends span many decades; a click types them.
  const std::string unit(info.unit);
  Setting low = view_setting("Lowest", unit, 0, 0, "Everything at or below this value gets the first colour.");
  Setting high = view_setting("Highest", unit, 0, 0, "Everything at or above this value gets the last colour.");
  low.max = view.range_max;
  high.min = view.range_min;
  low.open_max = high.open_min = true;
  view_number(m, "view/low", low, view.range_min, std::nan(""));
  view_number(m, "view/high", high, view.range_max, std::nan(""));
}

void choose_layers(PanelMemory& m, ViewState& view, int dimension) {
  heading("Show");
  checkbox("particles", "Particles", &view.show_particles);
  if (view.show_particles) {
    ImGui::Indent(em());
    checkbox("deformed", dimension == 2 ? "As deformed squares" : "As deformed ellipsoids", &view.deformed_particles);
    tooltip("Each particle is drawn as the piece of material it stands for, stretched and turned by its deformation.");
    ImGui::Unindent(em());
  }
  checkbox("grid", "Grid: cells and nodes in use (G)", &view.show_grid);
  checkbox("velocities", "Node velocities as arrows (V)", &view.show_velocities);
  checkbox("crosses", "Principal stress crosses (X)", &view.show_crosses);
  tooltip("A line along each principal direction, as long as the stress is large: red pulls, blue pushes.");
  checkbox("bent", "Grid bent by the step", &view.show_bent_grid);
  tooltip("The grid's lines, moved by the newest step. After each step the grid starts afresh.");
  if (view.show_bent_grid) {
    Setting s = view_setting("Magnified", "", 1, 1000, "How many times the step's displacement is exaggerated.");
    s.logarithmic = true;
    s.min = 0;
    view_number(m, "view/bent", s, view.bent_magnification, 1);
  }
  checkbox("boundaries", "Walls, constraints and loads", &view.show_boundaries);
}

}  // namespace

void draw_view_panel(AppContext& context) {
  PanelMemory& m = memory(context);
  ViewState& view = context.view;
  choose_field(context);
  choose_range(m, context);
  choose_layers(m, view, context.scene.dimension);
  heading("Window");
  int theme = view.theme == Theme::dark ? 0 : 1;
  outlined_radio("Dark", &theme, 0);
  ImGui::SameLine();
  outlined_radio("Light", &theme, 1);
  view.theme = theme == 0 ? Theme::dark : Theme::light;
  double scale = std::round(100 * static_cast<double>(view.ui_scale));
  Setting s = view_setting("Size of text and controls", "%", 75, 250, "Size of everything but the view itself.");
  s.min = 50;
  s.max = 400;
  if (view_number(m, "view/scale", s, scale, 100)) view.ui_scale = static_cast<float>(scale / 100);
}

}  // namespace pf::app
