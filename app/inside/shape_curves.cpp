#include "app/inside/shape_curves.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "app/imgui_painter.hpp"
#include "app/theme.hpp"
#include "app/widgets/text.hpp"
#include "core/charts/theme.hpp"

namespace pf::app {

namespace {

/// All weights at s: of the spline, or its means over the domain.
void weights_over(const BasisInfo& basis, double s, const std::vector<DomainPiece>& domain, long long& base,
                  double* N) {
  std::array<double, max_nodes_per_axis> dN{};
  basis.weights(s, base, N, dN.data());
  if (!basis.averaged() || domain.empty()) return;
  std::fill_n(N, basis.nodes_per_axis, 0.0);
  const double t = s - static_cast<double>(base);
  for (std::size_t q = 0; q < domain.size(); q += 4) {  // a lane a piece
    FourNumbers place{t, t, t, t}, width{1, 1, 1, 1}, share{};
    for (std::size_t k = 0; k < std::min<std::size_t>(4, domain.size() - q); ++k) {
      place[k] += domain[q + k].at;
      width[k] = domain[q + k].width;
      share[k] = domain[q + k].share;
    }
    std::array<FourNumbers, max_nodes_per_axis> mean{}, slope{};
    basis.mean_four(place, width, mean.data(), slope.data());
    for (int r = 0; r < basis.nodes_per_axis; ++r)
      for (int k = 0; k < 4; ++k) N[r] += share[k] * mean[static_cast<std::size_t>(r)][k];
  }
}

}  // namespace

std::vector<DomainPiece> domain_along(const Scene& scene, const ParticleState& particle, int axis, const float* rest) {
  const BasisInfo* basis = find_basis(scene.grid.basis);
  if (basis == nullptr || !basis->averaged() || particle.body >= scene.bodies.size()) return {};
  const double dx = scene.grid.spacing;
  const Body& body = scene.bodies[particle.body];
  const double l_0 = body.sampling == "lattice" ? 1.0 / body.particles_per_axis
                                                : std::pow(particle.volume0, 1.0 / scene.dimension) / dx;
  if (scene.dimension == 3) {
    Mat<3> edge = l_0 * particle.F;
    if (rest) edge = particle.F * Eigen::Map<const Eigen::Matrix3f>(rest).cast<double>() / dx;
    return domain_pieces<3>(edge.data(), axis);
  }
  Mat<2> edge = l_0 * particle.F.topLeftCorner<2, 2>();
  if (rest) edge = particle.F.topLeftCorner<2, 2>() * Eigen::Map<const Eigen::Matrix2f>(rest).cast<double>() / dx;
  return domain_pieces<2>(edge.data(), axis);
}

double shape_value(const BasisInfo& basis, double s, long long node, const std::vector<DomainPiece>& domain) {
  long long base = 0;
  std::array<double, max_nodes_per_axis> N{};
  weights_over(basis, s, domain, base, N.data());
  const long long r = node - base;
  return r >= 0 && r < basis.nodes_per_axis ? N[static_cast<std::size_t>(r)] : 0;
}

void draw_shape_curves(Painter& painter, const ShapeCurves& c) {
  const ChartTheme look = c.theme == Theme::dark ? dark_theme() : light_theme();
  const int K = c.basis->nodes_per_axis;
  long long base = 0;
  std::array<double, max_nodes_per_axis> N{};
  weights_over(*c.basis, c.s, c.domain, base, N.data());
  const double low = static_cast<double>(base) - 0.5 * K, high = static_cast<double>(base) + 1.5 * K - 1;
  const std::array axis{c.place(low, 0), c.place(high, 0)};
  painter.polyline(axis, look.axis, 0.08F * c.em);
  for (int k = 0; k < K; ++k) {
    const auto node = static_cast<double>(base + k);
    constexpr int samples = 48;
    std::vector<Point2> curve;
    for (int i = 0; i <= samples; ++i) {
      const double s = node + 0.5 * K * (2.0 * i / samples - 1);
      // At the ends of the support the next cell's formula would answer.
      curve.push_back(c.place(s, i == 0 || i == samples ? 0 : shape_value(*c.basis, s, base + k, c.domain)));
    }
    painter.polyline(curve, look.series[static_cast<std::size_t>(k)], 0.13F * c.em);
    painter.circle(c.place(node, 0), 0.2F * c.em, look.axis);
  }
  const std::array cut{c.place(c.s, 0), c.place(c.s, 1)};
  painter.polyline(cut, look.text, 0.07F * c.em, 0.3F * c.em);
  for (int k = 0; k < K; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Point2 at = c.place(c.s, N[i]);
    painter.circle(at, 0.26F * c.em, look.series[i]);
    if (!c.values) continue;
    char text[16];
    std::snprintf(text, sizeof text, "%.2f", N[i]);
    const Point2 words = c.place(high, 0);
    painter.text({words.x + c.aside, words.y - 0.25F * c.em - static_cast<float>(K - 1 - k) * 1.05F * c.em}, text,
                 0.85F * c.em, look.series[i], TextAlign::right);
  }
}

void shape_plot(const AppContext& context, const ParticleState& particle) {
  const BasisInfo* basis = find_basis(context.scene.grid.basis);
  if (basis == nullptr) return;
  const char* const names[] = {"x", "y", "z"};
  for (int a = 0; a < context.scene.dimension; ++a) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = em(4.2F), left = em(1.1F), right = em(2.3F);
    ImGui::Dummy(ImVec2(width, height + em(0.4F)));
    ImGuiPainter painter(*ImGui::GetWindowDrawList());
    ShapeCurves curves;
    curves.basis = basis;
    curves.s = particle.x[a] / context.scene.grid.spacing;
    const float* const rest = context.snapshot ? context.snapshot->domain_of(particle.id) : nullptr;
    curves.domain = domain_along(context.scene, particle, a, rest);
    curves.em = em();
    curves.theme = context.view.theme;
    long long base = 0;
    std::array<double, max_nodes_per_axis> N{}, dN{};
    basis->weights(curves.s, base, N.data(), dN.data());
    const double low = static_cast<double>(base) - 0.5 * basis->nodes_per_axis, span = 2.0 * basis->nodes_per_axis - 1;
    curves.aside = right;
    curves.place = [&](double s, double n) {
      const double u = (s - low) / span;
      return Point2{at.x + left + static_cast<float>(u) * (width - left - right),
                    at.y + height - static_cast<float>(n) * (height - em(0.4F))};
    };
    draw_shape_curves(painter, curves);
    const ImVec4 c = ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
    painter.text({at.x, at.y + height}, names[a], em(), {c.x, c.y, c.z, c.w});
  }
}

}  // namespace pf::app
