// Particle: everything that is known of the selected one.
#include <imgui.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "app/panels/panels.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

std::string body_name(const AppContext& context, std::size_t body) {
  if (body >= context.scene.bodies.size()) return std::to_string(body);
  const std::string& name = context.scene.bodies[body].name;
  return name.empty() ? "Body " + std::to_string(body + 1) : name;
}

/// A factor for all entries and the unit with its prefix: one prefix for each entry would be hard to compare.
std::pair<double, std::string> common_unit(double largest, const std::string& unit) {
  const std::array<std::pair<double, const char*>, 3> prefixes{{{1e9, "G"}, {1e6, "M"}, {1e3, "k"}}};
  if (unit == "Pa")
    for (const auto& [scale, prefix] : prefixes)
      if (largest >= scale) return {scale, prefix + unit};
  return {1, unit};
}

/// Rows x columns of the upper left corner, right-aligned, with as many digits as fit.
void table(const char* title, const Mat3& a, int rows, int columns, const std::string& unit) {
  const auto [factor, shown] = common_unit(a.topLeftCorner(rows, columns).cwiseAbs().maxCoeff(), unit);
  heading((shown.empty() ? std::string(title) : title + (" [" + shown + "]")).c_str());
  const float width = ImGui::GetContentRegionAvail().x / static_cast<float>(columns), left = ImGui::GetCursorPosX();
  const auto text = [&, f = factor](int i, int j, int digits) { return quantity(a(i, j) / f, "", digits); };
  int digits = 5;
  for (bool fits = false; !fits && digits > 2;) {
    fits = true;
    --digits;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) fits &= ImGui::CalcTextSize(text(i, j, digits).c_str()).x + em(0.4F) <= width;
  }
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const std::string entry = text(i, j, digits);
      if (j > 0) ImGui::SameLine();
      ImGui::SetCursorPosX(left + width * static_cast<float>(j + 1) - ImGui::CalcTextSize(entry.c_str()).x);
      text_unformatted(entry);
    }
}

void vector_row(const char* title, const Vec3& v, int d, const char* unit) {
  Mat3 row = Mat3::Zero();
  row.row(0) = v.transpose();
  table(title, row, 1, d, unit);
}

void draw_stretch(const ParticleState& p, int d) {
  table("Deformation gradient F", p.F, d, d, "");
  gap(0.25F);
  property("Volume ratio J", quantity(p.F.determinant(), ""));
  const Eigen::JacobiSVD<Mat3> svd(p.F);
  std::string stretches;
  for (int a = 0; a < d; ++a) {
    // In 2D the third stretch is 1 by plane strain and is left out: show the two in the plane.
    const Mat<2> plane = p.F.topLeftCorner<2, 2>();
    const double s = d == 3 ? svd.singularValues()[a] : Eigen::JacobiSVD<Mat<2>>(plane).singularValues()[a];
    stretches += (a > 0 ? "  " : "") + quantity(s, "");
  }
  property("Principal stretches", stretches);
}

void draw_stress(const ParticleState& p, int d) {
  table("Cauchy stress", p.sigma, d, d, "Pa");
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

}  // namespace

void draw_particle_panel(AppContext& context) {
  if (!context.selected_particle) return;
  const std::string title = "Particle " + std::to_string(*context.selected_particle);
  ImGui::AlignTextToFramePadding();
  text_unformatted(title);
  const float close = ImGui::CalcTextSize("Close").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - close);
  if (ImGui::Button("Close")) {
    context.selected_particle.reset();
    return;
  }
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
}

}  // namespace pf::app
