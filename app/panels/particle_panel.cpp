// Particle: everything that is known of the selected one.
#include <imgui.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <string>

#include "app/inside/shape_curves.hpp"
#include "app/panels/numbers.hpp"
#include "app/panels/panels.hpp"
#include "app/theme.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/charts/ticks.hpp"

namespace pf::app {

namespace {

std::string body_name(const AppContext& context, std::size_t body) {
  if (body >= context.scene.bodies.size()) return std::to_string(body);
  const std::string& name = context.scene.bodies[body].name;
  return name.empty() ? "Body " + std::to_string(body + 1) : name;
}

void draw_stretch(const ParticleState& p, int d) {
  matrix_table("Deformation gradient F", p.F, d, d, "");
  gap(0.25F);
  property("Volume ratio J", quantity(p.F.determinant(), ""));
  const Eigen::JacobiSVD<Mat3> svd(p.F);
  std::string stretches;
  for (int a = 0; a < d; ++a) {
    // In 2D the third stretch is 1 by plane strain and is left out: show the two in the plane.
    const Mat<2> plane = p.F.topLeftCorner<2, 2>();
    const double s = d == 3 ? svd.singularValues()[a] : Eigen::JacobiSVD<Mat<2>>(plane).singularValues()[a];
    stretches += (a > 0 ? "  " : "") + number_text(s, 4);
  }
  property("Principal stretches", stretches);
}

void draw_stress(const ParticleState& p, int d) {
  matrix_table("Cauchy stress", p.sigma, d, d, "Pa");
  gap(0.25F);
  if (d == 2) property("Across the plane", quantity(p.sigma(2, 2), "Pa"));
  const double pressure = -p.sigma.trace() / 3;
  const Mat3 deviator = p.sigma + pressure * Mat3::Identity();
  property("von Mises stress", quantity(std::sqrt(1.5) * deviator.norm(), "Pa"));
  property("Pressure", quantity(pressure, "Pa"));
  tooltip("Positive in compression.");
  property("Energy density", quantity(p.energy_density, "J/m\xc2\xb3"));
  tooltip("Stored elastic energy in a cubic metre of undeformed material.");
}

/// The nodes that it meets: a click selects one.
void draw_nodes(AppContext& context, const ParticleLook& look, int d) {
  if (!foldable("Shape functions", true)) return;
  shape_plot(context, look.state);
  constexpr auto flags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings;
  if (d == 3) {  // three components have no room beside the others
    for (const NodeWeight& n : look.nodes) {
      const float left = ImGui::GetCursorPosX();
      const std::string id = "##" + index_text(n.node, d);
      if (ImGui::Selectable(id.c_str(), context.selected_node == n.node)) context.selected_node = n.node;
      ImGui::SameLine();
      ImGui::SetCursorPosX(left);
      property("w of " + index_text(n.node, d), quantity(n.w, "", 3));
      property("\xe2\x88\x87w [1/m]", vector_text(n.grad, d, "", 2));
    }
  } else if (ImGui::BeginTable("nodes", 3, flags)) {
    for (const char* head : {"Node", "w", "\xe2\x88\x87w [1/m]"}) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", head);
    }
    for (const NodeWeight& n : look.nodes) {
      ImGui::TableNextColumn();
      const bool chosen = context.selected_node == n.node;
      if (ImGui::Selectable(index_text(n.node, d).c_str(), chosen, ImGuiSelectableFlags_SpanAllColumns))
        context.selected_node = n.node;
      ImGui::TableNextColumn();
      text_unformatted(quantity(n.w, "", 3));
      ImGui::TableNextColumn();
      text_unformatted(vector_text(n.grad, d, "", 2));
    }
    ImGui::EndTable();
  }
  property("Sum of w", quantity(look.weight_sum, "", 6));
  tooltip("1 but for rounding: the functions are a partition of unity.");
  const double steepest = 1 / context.scene.grid.spacing;
  property("Sum of \xe2\x88\x87w",
           look.gradient_sum.norm() < 1e-11 * steepest ? "0" : vector_text(look.gradient_sum, d, "1/m"));
  tooltip("0 but for rounding: a rigid motion deforms nothing.");
}

}  // namespace

void draw_particle_panel(AppContext& context) {
  if (!context.selected_particle) return;
  const std::string title = "Particle " + std::to_string(*context.selected_particle);
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(bold_font());
  text_unformatted(title);
  ImGui::PopFont();
  const float close = ImGui::CalcTextSize("Close").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - close);
  if (ImGui::Button("Close")) {
    context.selected_particle.reset();
    return;
  }
  ImGui::Separator();
  if (!context.inspected || context.inspected->id != *context.selected_particle) {
    muted("Its values arrive after the running step.");
    return;
  }
  const ParticleState& p = *context.inspected;
  const int d = context.scene.dimension;
  property("Body", body_name(context, p.body));
  if (p.material < context.scene.materials.size()) property("Material", context.scene.materials[p.material].name);
  property("Mass", quantity(p.mass, "kg"));
  property("Volume at rest", quantity(p.volume0, d == 3 ? "m\xc2\xb3" : "m\xc2\xb2"));
  vector_row("Position", p.x, d, "m");
  vector_row("Position at rest", p.X, d, "m");
  vector_row("Velocity", p.v, d, "m/s");
  property("Speed", quantity(p.v.norm(), "m/s"));
  draw_stretch(p, d);
  draw_stress(p, d);
  if (!context.looked || !context.looked->particle || context.looked->particle->state.id != p.id) return;
  property("Energy", quantity(context.looked->particle->energy, "J"));
  draw_nodes(context, *context.looked->particle, d);
}

}  // namespace pf::app
