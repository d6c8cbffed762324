// Material: law and parameters, and what follows from them.
#include <imgui.h>

#include <algorithm>

#include "app/panels/limits.hpp"
#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/widgets/setting_widget.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/materials/law.hpp"

namespace pf::app {

namespace {

/// Another law for the same material: parameters that both laws have are kept, others start at a typical value.
std::vector<Edit> change_law(const Material& material, const std::string& model) {
  nlohmann::json to{{"model", model}, {"density", material.density}};
  if (const LawInfo* law = find_law(model))
    for (const LawParameter& p : law->parameters) {
      const auto kept = std::find_if(material.parameters.begin(), material.parameters.end(),
                                     [&](const auto& have) { return have.first == p.key; });
      to[std::string(p.key)] = kept != material.parameters.end() ? kept->second : p.typical;
    }
  if (material.f_bar) to["f_bar"] = true;
  return {{pointer_to({"materials", material.name}), to}};
}

const Material* chosen_material(const AppContext& context, std::string& chosen) {
  const auto& materials = context.scene.materials;
  if (materials.empty()) return nullptr;
  auto it = std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == chosen; });
  if (it == materials.end()) it = materials.begin();
  chosen = it->name;
  return &*it;
}

void choose_material(const AppContext& context, std::string& chosen) {
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (!ImGui::BeginCombo("##material", chosen.c_str())) return;
  for (const Material& m : context.scene.materials)
    if (ImGui::Selectable(m.name.c_str(), m.name == chosen)) chosen = m.name;
  ImGui::EndCombo();
}

void draw_consequences(const Scene& scene, const Material& material) {
  const double c = wave_speed(material);
  heading("What follows");
  property("Speed of pressure waves", quantity(c, "m/s", 3));
  tooltip("How fast a push travels through the undeformed material: sqrt((lambda + 2 mu) / density).");
  if (c > 0) property("Longest explicit step", "about " + quantity(scene.grid.spacing / c, "s", 2));
  tooltip("The time a pressure wave needs for one cell. An explicit step must be shorter; an implicit one need not.");
}

}  // namespace

void draw_material_panel(AppContext& context) {
  PanelMemory& m = memory(context);
  const Material* const found = chosen_material(context, m.scene_material);
  if (found == nullptr) {
    muted("The scene has no material.");
    return;
  }
  if (context.scene.materials.size() > 1) choose_material(context, m.scene_material);
  // A copy: an edit below replaces the scene.
  const Material material = *chosen_material(context, m.scene_material);
  ImGui::PushID(material.name.c_str());
  setting_widget(context, pointer_to({"materials", material.name, "model"}),
                 {.edits = [&](const nlohmann::json& to) { return change_law(material, to.get<std::string>()); }});
  if (const LawInfo* law = find_law(material.model)) {
    const std::size_t stop = law->about.find(". ");
    muted(law->about.substr(0, stop == std::string_view::npos ? stop : stop + 1));
    tooltip(law->about);
    gap();
  }
  setting_widget(context, pointer_to({"materials", material.name, "density"}));
  for (const auto& [key, value] : material.parameters)
    setting_widget(context, pointer_to({"materials", material.name, key}));
  setting_widget(context, pointer_to({"materials", material.name, "f_bar"}));
  draw_consequences(context.scene, material);
  ImGui::PopID();
}

}  // namespace pf::app
