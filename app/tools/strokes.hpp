// What the tools that work on the material have in common: a brush of so many cells, and where it is.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/tools/tool.hpp"
#include "app/widgets/slider.hpp"

namespace pf::app {

/// Its size means the same in every scene, and is kept from stroke to stroke.
class Brush {
 public:
  explicit Brush(double cells) : cells_(cells) {}
  static constexpr double least = 0.5, most = 40;  ///< [cells]
  double radius(const Snapshot& s) const { return cells_ * s.spacing; }
  /// A slider for it, of the height of two lines.
  void draw_size() {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f cells", cells_);
    const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
    ImGui::TextDisabled("Radius");
    ImGui::SameLine(left + width - ImGui::CalcTextSize(text).x);
    ImGui::TextUnformatted(text);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
    slider("##size", cells_, {least, 12, true}, std::nan(""));
  }
  void turn(float notches) { cells_ = std::clamp(cells_ * std::pow(1.15, static_cast<double>(notches)), least, most); }
  /// A dark line under a light one shows on every colour.
  void draw(Painter& painter, const ViewMap& map, const Snapshot& s, const Vec3& at, float strength,
            const Color& color = {1, 1, 1, 0.9F}) const {
    const auto centre = map.to_pixel(at);
    if (!centre) return;
    const auto r = static_cast<float>(radius(s) / map.metres_per_pixel(at));
    painter.ring(*centre, r, {0, 0, 0, 0.45F * strength}, 0.22F * map.em());
    painter.ring(*centre, r, {color.r, color.g, color.b, color.a * strength}, 0.1F * map.em());
  }

 private:
  double cells_;
};

/// The point of the material under the mouse: in 2D the mouse's own, in 3D the particle's. Nothing beside it.
inline std::optional<Vec3> touched(const ViewMouse& mouse, const AppContext& context) {
  if (!context.snapshot) return std::nullopt;
  const Snapshot& s = *context.snapshot;
  const auto& x = s.x;
  if (mouse.dimension == 2) {
    const double reach = 0.75 * s.spacing;  // of one particle: between particles is material, too
    for (std::size_t k = 0; k < s.particles; ++k)
      if (std::hypot(x[2 * k] - mouse.origin.x(), x[2 * k + 1] - mouse.origin.y()) < reach) return mouse.origin;
    return std::nullopt;
  }
  if (!mouse.particle || *mouse.particle >= s.particles) return std::nullopt;
  const std::size_t p = 3 * *mouse.particle;
  return Vec3(x[p], x[p + 1], x[p + 2]);
}

inline nlohmann::json ball_json(const Vec3& centre, double radius, int dimension) {
  nlohmann::json at = nlohmann::json::array();
  for (int k = 0; k < dimension; ++k) at.push_back(centre[k]);
  return {{"type", "ball"}, {"center", at}, {"radius", radius}};
}

}  // namespace pf::app
