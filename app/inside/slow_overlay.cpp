#include "app/inside/slow_overlay.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/inside/marks.hpp"
#include "app/inside/step_player.hpp"
#include "core/look.hpp"

namespace pf::app {

namespace {

/// What one frame of the overlay is drawn with.
struct Scenery {
  Painter& painter;
  const ViewMap& map;
  const AppContext& context;
  const StepPlayer& player;
  float em;

  const StepRecord& record() const { return player.record(); }
  Vec3 home(std::size_t i) const {
    const NodeIndex n = player.node(i);
    return record().spacing * Vec3(n[0], n[1], n[2]);
  }
  /// Where a node is drawn.
  Vec3 place(std::size_t i) const { return home(i) + player.magnification() * player.node_displacement(i); }
};

/// In 3D, and where nodes are many, marks on all of them would hide the body.
bool marks_all_nodes(const Scenery& s) {
  const auto cell = s.record().spacing / s.map.metres_per_pixel(s.record().spacing * Vec3::Zero());
  return s.record().dimension == 2 && cell > 0.35 * static_cast<double>(s.em);
}

/// Discs whose area is the mass that a node has got so far.
void draw_masses(const Scenery& s, double share) {
  const std::vector<double>& m = s.record().node_mass;
  const double most = m.empty() ? 1 : *std::max_element(m.begin(), m.end());
  for (std::size_t i = 0; i < m.size(); ++i) {
    const Vec3 x = s.place(i);
    const auto at = s.map.to_pixel(x);
    if (!at) continue;
    const auto cell = static_cast<float>(s.record().spacing / s.map.metres_per_pixel(x));
    const auto part = static_cast<float>(std::sqrt(share * m[i] / most));
    if (part > 0.02F) mark_disc(s.painter, *at, std::min(0.32F * cell, 0.9F * s.em) * part, mark_blue);
  }
}

double largest_of(const std::vector<double>& values, int dimension) {
  double most = 0;
  for (std::size_t i = 0; i * static_cast<std::size_t>(dimension) < values.size(); ++i)
    most = std::max(most, entry(values, i, dimension).norm());
  return most;
}

/// Lines between the watched particle and its nodes; dots run along them, towards the nodes or back.
void draw_traffic(const Scenery& s, const Vec3& at, double run, bool towards_nodes) {
  const auto p = s.context.selected_particle ? s.player.find_particle(*s.context.selected_particle) : std::nullopt;
  const auto centre = s.map.to_pixel(at);
  if (!p || !centre) return;
  for (const NodeWeight& n : recorded_weights(s.record(), *p)) {
    if (n.w == 0) continue;  // beyond its domain
    const auto i = s.player.find_node(n.node);
    if (!i || !s.player.draws(*i)) continue;
    const auto end = s.map.to_pixel(s.place(*i));
    if (!end) continue;
    const auto w = static_cast<float>(n.w);
    mark_line(s.painter, *centre, *end, {1, 1, 1, 0.2F + 0.7F * w}, (0.05F + 0.22F * w) * s.em);
    const auto f = static_cast<float>(towards_nodes ? run : 1 - run);
    if (run > 0.01 && run < 0.99)
      mark_disc(s.painter, {centre->x + f * (end->x - centre->x), centre->y + f * (end->y - centre->y)},
                (0.12F + 0.55F * std::sqrt(w)) * s.em * 0.7F, mark_amber);
    char text[16];
    std::snprintf(text, sizeof text, "%.2f", n.w);
    const auto cell = static_cast<float>(s.record().spacing / s.map.metres_per_pixel(at));
    if (cell > 3.5F * s.em) mark_label(s.painter, *end, text, s.em);
  }
  s.painter.ring(*centre, 0.5F * s.em, mark_rim, 0.3F * s.em);
  s.painter.ring(*centre, 0.5F * s.em, mark_white, 0.14F * s.em);
}

void draw_watched_node(const Scenery& s) {
  const auto i = s.context.selected_node ? s.player.find_node(*s.context.selected_node) : std::nullopt;
  if (!i) return;
  const auto at = s.map.to_pixel(s.place(*i)), home = s.map.to_pixel(s.home(*i));
  if (!at || !home) return;
  if (std::hypot(at->x - home->x, at->y - home->y) > 0.5F * s.em)
    mark_line(s.painter, *home, *at, mark_green, 0.12F * s.em);
  s.painter.ring(*at, 0.6F * s.em, mark_rim, 0.34F * s.em);
  s.painter.ring(*at, 0.6F * s.em, mark_green, 0.17F * s.em);
}

/// What arrows show now: a force on every node, and the one whose arrow is longest.
struct ShownForces {
  std::vector<double> force;
  double largest = 0;
};

ShownForces shown_forces(const StepPlayer& player) {
  const StepRecord& record = player.record();
  const Phase& phase = player.phase();
  const bool arrived = player.motion() >= 0.97;
  const auto residual = [&](std::size_t k) {
    return ShownForces{record.iterates[k].residual, largest_of(record.iterates.front().residual, record.dimension)};
  };
  switch (phase.kind) {
    case PhaseKind::guess:
      return arrived ? residual(0) : ShownForces{};
    case PhaseKind::iterate:
      return residual(arrived ? phase.iterate : phase.iterate - 1);
    case PhaseKind::kick: {
      std::vector<double> total = record.internal_start;
      for (std::size_t k = 0; k < total.size(); ++k) total[k] += record.external_start[k];
      const double largest = largest_of(total, record.dimension);
      return {std::move(total), largest};
    }
    default:
      return {};
  }
}

/// Length of an arrow [m/N]; 0: none is drawn. The longest is a little more than a cell.
double arrow_scale(const StepPlayer& player, const ShownForces& shown) {
  return shown.largest > 0 ? 1.2 * player.record().spacing / shown.largest : 0;
}

void draw_forces(const Scenery& s) {
  const ShownForces shown = shown_forces(s.player);
  const double scale = arrow_scale(s.player, shown);
  if (!(scale > 0)) return;
  for (std::size_t i = 0; i < s.record().nodes(); ++i) {
    const Vec3 f = entry(shown.force, i, s.record().dimension);
    if (!s.player.draws(i)) continue;
    if (f.norm() < 0.02 * shown.largest) continue;
    const Vec3 x = s.place(i);
    const auto from = s.map.to_pixel(x), to = s.map.to_pixel(x + scale * f);
    if (from && to) mark_arrow(s.painter, *from, *to, mark_red, 0.75F * s.em);
  }
}

}  // namespace

double slow_force_scale(const StepPlayer& player) {
  return arrow_scale(player, shown_forces(player));
}

void draw_slow_step(Painter& painter, const ViewMap& map, const AppContext& context) {
  const StepPlayer& player = *context.slow;
  const Scenery s{painter, map, context, player, map.em()};
  const Phase& phase = player.phase();
  const double f = player.motion();
  const bool all = marks_all_nodes(s);
  const auto p = context.selected_particle ? player.find_particle(*context.selected_particle) : std::nullopt;
  Vec3 at = Vec3::Zero();
  if (p && *p * static_cast<std::size_t>(s.record().dimension) < context.snapshot->x.size())
    at = entry(context.snapshot->x, *p, s.record().dimension);
  switch (phase.kind) {
    case PhaseKind::give:
      if (all) draw_masses(s, f);
      draw_traffic(s, at, f, true);
      break;
    case PhaseKind::guess:
    case PhaseKind::iterate:
    case PhaseKind::kick:
      draw_forces(s);
      break;
    case PhaseKind::ride:
      draw_traffic(s, at, f, false);
      break;
    case PhaseKind::extrapolate:
    case PhaseKind::snap:
      break;
  }
  draw_watched_node(s);
}

}  // namespace pf::app
