// Node: what the coming step will find at the selected node, and who brings it.
#include <imgui.h>

#include <algorithm>
#include <string>

#include "app/panels/numbers.hpp"
#include "app/panels/panels.hpp"
#include "app/theme.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

void draw_contributors(AppContext& context, const NodeLook& n) {
  const std::string title = "From " + std::to_string(n.contributors) + " particles";
  if (!foldable(title.c_str(), true)) return;
  constexpr auto flags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings;
  if (!ImGui::BeginTable("particles", 3, flags)) return;
  for (const char* head : {"Particle", "w", "Mass"}) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", head);
  }
  for (const Contribution& c : n.largest) {
    ImGui::TableNextColumn();
    const bool chosen = context.selected_particle == c.particle;
    if (ImGui::Selectable(std::to_string(c.particle).c_str(), chosen, ImGuiSelectableFlags_SpanAllColumns))
      context.selected_particle = c.particle;
    ImGui::TableNextColumn();
    text_unformatted(quantity(c.w, "", 3));
    ImGui::TableNextColumn();
    text_unformatted(quantity(100 * c.mass / n.mass, "", 3) + " %");
  }
  ImGui::EndTable();
  if (n.contributors > n.largest.size())
    muted("and " + std::to_string(n.contributors - n.largest.size()) + " lighter ones");
}

}  // namespace

void draw_node_panel(AppContext& context) {
  if (!context.selected_node) return;
  const int d = context.scene.dimension;
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(bold_font());
  text_unformatted("Node " + index_text(*context.selected_node, d));
  ImGui::PopFont();
  const float close = ImGui::CalcTextSize("Close").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - close);
  if (ImGui::Button("Close##node")) {
    context.selected_node.reset();
    return;
  }
  ImGui::Separator();
  if (!context.looked || !context.looked->node || context.looked->node->node != *context.selected_node) {
    muted("Its values arrive after the running step.");
    return;
  }
  const NodeLook& n = *context.looked->node;
  vector_row("Position", n.x, d, "m");
  if (!n.active) {
    muted("No particle is within its reach: it takes no part in the step.");
    return;
  }
  gap(0.25F);
  property("Mass", quantity(n.mass, "kg"));
  vector_row("Velocity", n.velocity, d, "m/s");
  tooltip("The particles' momentum over the node's mass: what the coming step starts from.");
  vector_row("Internal force", n.internal, d, "N");
  tooltip("Of the stress of the particles around it, before the coming step.");
  vector_row("External force", n.external, d, "N");
  tooltip("Gravity, body forces and tractions.");
  if (n.residual) {
    vector_row("Residual left by the last step", *n.residual, d, "N");
    tooltip("What Newton's method left unbalanced here when it stopped.");
  }
  draw_contributors(context, n);
}

}  // namespace pf::app
