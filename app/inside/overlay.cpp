#include "app/inside/overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/inside/marks.hpp"
#include "app/inside/shape_curves.hpp"
#include "app/inside/slow_overlay.hpp"
#include "app/inside/step_player.hpp"
#include "core/bases/basis.hpp"

namespace pf::app {

namespace {

Vec3 place_of(const NodeIndex& i, double spacing) {
  return spacing * Vec3(i[0], i[1], i[2]);
}

/// Discs as large as weights, arrows along gradients, a line to the point that they belong to.
void draw_stencil(Painter& painter, const ViewMap& map, const Vec3& x, const std::vector<NodeWeight>& nodes,
                  double dx) {
  const auto centre = map.to_pixel(x);
  if (!centre) return;
  const auto cell = static_cast<float>(dx / map.metres_per_pixel(x));
  const float smaller = std::min(1.0F, cell / (2.2F * map.em()));  // where cells are small
  double steepest = 0;
  for (const NodeWeight& n : nodes) steepest = std::max(steepest, n.grad.norm());
  for (const NodeWeight& n : nodes)
    if (const auto at = map.to_pixel(place_of(n.node, dx)))
      mark_line(painter, *centre, *at, {1, 1, 1, 0.12F + 0.6F * static_cast<float>(n.w)}, 0.07F * map.em());
  for (const NodeWeight& n : nodes) {
    const auto at = map.to_pixel(place_of(n.node, dx));
    if (!at) continue;
    const float largest = std::min(0.5F * cell, 1.6F * map.em());
    mark_disc(painter, *at, std::max(1.5F, largest * static_cast<float>(std::sqrt(std::max(0.0, n.w)))), mark_blue);
    const auto tip = map.to_pixel(place_of(n.node, dx) + 0.45 * dx / std::max(steepest, 1e-300) * n.grad);
    if (tip && cell > 0.8F * map.em()) mark_arrow(painter, *at, *tip, mark_amber, 0.8F * smaller * map.em());
    if (cell < 5 * map.em()) continue;
    char text[16];
    std::snprintf(text, sizeof text, "%.3f", n.w);
    mark_label(painter, *at, text, map.em());
  }
  mark_disc(painter, *centre, 0.28F * smaller * map.em(), mark_white);
}

/// What the step's own weights are known of: the particle that is looked at, where this picture shows it.
const ParticleLook* looked_at(const AppContext& context, const Vec3& x) {
  if (!context.looked || !context.looked->particle) return nullptr;
  const ParticleLook& look = *context.looked->particle;
  const bool here =
      context.selected_particle == look.state.id && (look.state.x - x).norm() < 1e-9 * context.snapshot->spacing;
  return here ? &look : nullptr;
}

/// 2D: the functions of each axis, below and to the left of the stencil, where its nodes are.
void draw_curves(Painter& painter, const ViewMap& map, const Vec3& x, const std::vector<NodeWeight>& nodes,
                 const AppContext& context) {
  const double dx = context.snapshot->spacing;
  const BasisInfo* basis = find_basis(context.scene.grid.basis);
  const auto cell = static_cast<float>(dx / map.metres_per_pixel(x));
  const float em = map.em();
  if (basis == nullptr || cell < 0.7F * em) return;
  const auto corner = map.to_pixel(place_of(nodes.front().node, dx)), point = map.to_pixel(x);
  if (!corner || !point) return;
  const float height = std::clamp(1.1F * cell, 2.4F * em, 5 * em), off = 0.8F * em + 0.5F * cell;
  const double K = basis->nodes_per_axis;
  for (int a = 0; a < 2; ++a) {
    ShapeCurves curves;
    curves.basis = basis;
    curves.s = x[a] / dx;
    if (const ParticleLook* look = looked_at(context, x))
      curves.domain = domain_along(context.scene, look->state, a, context.snapshot->domain_of(look->state.id));
    curves.em = 0.9F * em;
    curves.theme = context.view.theme;
    curves.values = false;
    const double base = nodes.front().node[static_cast<std::size_t>(a)];
    const auto along = [&, a, base](double s) {
      const auto pixels = static_cast<float>((s - base) * static_cast<double>(cell));
      return a == 0 ? corner->x + pixels : corner->y - pixels;
    };
    const float foot = a == 0 ? corner->y + off + height : corner->x - off - height;
    curves.place = [&, a, foot](double s, double n) {
      const float up = static_cast<float>(n) * height;
      return a == 0 ? Point2{along(s), foot - up} : Point2{foot + up, along(s)};
    };
    const float begin = along(base - 0.5 * K), end = along(base + 1.5 * K - 1), pad = 0.35F * em;
    const Color paper = context.view.theme == Theme::dark ? Color{0.09F, 0.1F, 0.12F, 0.86F} : Color{1, 1, 1, 0.88F};
    if (a == 0)
      painter.rectangle({begin - pad, foot - height - pad}, {end + pad, foot + pad}, paper, 0.3F * em);
    else
      painter.rectangle({foot - pad, end - pad}, {foot + height + pad, begin + pad}, paper, 0.3F * em);
    draw_shape_curves(painter, curves);
  }
}

void draw_node(Painter& painter, const ViewMap& map, const NodeIndex& node, const AppContext& context) {
  const double dx = context.snapshot->spacing;
  const Vec3 x = place_of(node, dx);
  const auto at = map.to_pixel(x);
  if (!at) return;
  const float em = map.em();
  const auto cell = static_cast<float>(dx / map.metres_per_pixel(x));
  const float radius = std::clamp(0.45F * cell, 0.25F * em, 0.55F * em);
  painter.ring(*at, radius, mark_rim, 0.32F * em);
  painter.ring(*at, radius, mark_white, 0.16F * em);
  const BasisInfo* basis = find_basis(context.scene.grid.basis);
  if (context.snapshot->dimension != 2 || basis == nullptr) return;
  // Where its function is not zero.
  const double reach = 0.5 * basis->nodes_per_axis * dx;
  const auto low = map.to_pixel(x - Vec3(reach, reach, 0)), high = map.to_pixel(x + Vec3(reach, reach, 0));
  if (!low || !high) return;
  const std::array box{*low, Point2{high->x, low->y}, *high, Point2{low->x, high->y}, *low};
  painter.polyline(box, mark_rim, 0.2F * em, 0.5F * em);
  painter.polyline(box, mark_white, 0.1F * em, 0.5F * em);
}

void draw_worst(Painter& painter, const ViewMap& map, const AppContext& context) {
  const StepRecord* record = context.record.get();
  if (!context.wants_record || record == nullptr || record->step != context.snapshot->report.step) return;
  if (record->iterates.empty()) return;
  // Of the last iterate little more than rounding is left: show where the work began.
  const IterateRecord& first = record->iterates.front();
  if (first.worst < 0) return;
  const auto d = static_cast<std::size_t>(record->dimension);
  NodeIndex node{};
  std::copy_n(record->node_index.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(first.worst) * d), d,
              node.begin());
  const auto at = map.to_pixel(place_of(node, record->spacing));
  if (!at) return;
  painter.ring(*at, 0.8F * map.em(), mark_rim, 0.36F * map.em());
  painter.ring(*at, 0.8F * map.em(), mark_red, 0.18F * map.em());
  char text[64];
  std::snprintf(text, sizeof text, "Largest here: %.0f %% of the squared residual", 100 * first.worst_share);
  mark_label(painter, {at->x + 0.4F * map.em(), at->y}, text, map.em());
}

Vec3 particle_place(const Snapshot& s, std::size_t p) {
  const auto d = static_cast<std::size_t>(s.dimension);
  Vec3 x = Vec3::Zero();
  for (std::size_t a = 0; a < d; ++a) x[static_cast<int>(a)] = s.x[p * d + a];
  return x;
}

/// Whose shape functions are shown: the selected particle's, as it is in this picture, else those under the mouse.
std::optional<Vec3> point_of_interest(const ViewMouse* mouse, const AppContext& context) {
  const Snapshot& s = *context.snapshot;
  if (context.selected_particle) {
    const auto found = std::find(s.id.begin(), s.id.end(), *context.selected_particle);
    if (found == s.id.end()) return std::nullopt;
    return particle_place(s, static_cast<std::size_t>(found - s.id.begin()));
  }
  if (!context.view.show_shapes || mouse == nullptr) return std::nullopt;
  if (s.dimension == 2) return mouse->origin;
  if (!mouse->particle || *mouse->particle >= s.particles) return std::nullopt;
  return particle_place(s, *mouse->particle);
}

}  // namespace

void draw_inside(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context) {
  if (!context.snapshot) return;
  if (context.slow) return draw_slow_step(painter, map, context);
  const Snapshot& s = *context.snapshot;
  const BasisInfo* basis = find_basis(context.scene.grid.basis);
  const std::optional<Vec3> at = point_of_interest(mouse, context);
  if (at && basis != nullptr) {
    const ParticleLook* look = looked_at(context, *at);
    const std::vector<NodeWeight> nodes = look ? look->nodes : weights_at(*basis, s.spacing, s.dimension, *at);
    draw_stencil(painter, map, *at, nodes, s.spacing);
    if (s.dimension == 2) draw_curves(painter, map, *at, nodes, context);
  }
  draw_worst(painter, map, context);
  if (context.selected_node) draw_node(painter, map, *context.selected_node, context);
}

bool select_node(const ViewMouse& mouse, AppContext& context) {
  if (!context.snapshot || !(context.snapshot->spacing > 0)) return false;
  const Snapshot& s = *context.snapshot;
  if (s.dimension == 2) {
    NodeIndex node{};
    for (std::size_t a = 0; a < 2; ++a)
      node[a] = static_cast<std::int32_t>(std::lround(mouse.origin[static_cast<int>(a)] / s.spacing));
    context.selected_node = node;
    return true;
  }
  const BasisInfo* basis = find_basis(context.scene.grid.basis);
  if (!mouse.particle || *mouse.particle >= s.particles || basis == nullptr) return false;
  const Vec3 x = particle_place(s, *mouse.particle);
  double nearest = INFINITY;
  for (const NodeWeight& n : weights_at(*basis, s.spacing, 3, x)) {
    const Vec3 offset = place_of(n.node, s.spacing) - mouse.origin;
    const double d = (offset - offset.dot(mouse.direction) * mouse.direction).norm() - 0.05 * s.spacing * n.w;
    if (!(d < nearest)) continue;
    nearest = d;
    context.selected_node = n.node;
  }
  return true;
}

}  // namespace pf::app
