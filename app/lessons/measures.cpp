#include "app/lessons/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

constexpr std::array infos{
    MeasureInfo{"time", "simulated time [s]"},
    MeasureInfo{"steps", "steps made"},
    MeasureInfo{"dt", "length of the last step [s]"},
    MeasureInfo{"kinetic", "kinetic energy [J]"},
    MeasureInfo{"kinetic0", "at the start [J]"},
    MeasureInfo{"kinetic_most", "the most there was [J]"},
    MeasureInfo{"elastic", "elastic energy [J]"},
    MeasureInfo{"potential", "potential energy [J]"},
    MeasureInfo{"total", "all energy [J]"},
    MeasureInfo{"total0", "at the start [J]"},
    MeasureInfo{"total_most", "the most there was [J]"},
    MeasureInfo{"spin", "angular momentum about the origin [kg m^2/s]"},
    MeasureInfo{"spin0", "at the start [kg m^2/s]"},
    MeasureInfo{"spin_lost_transfer", "what transfers took of it since the start [kg m^2/s]"},
    MeasureInfo{"spin_lost_time", "what the time integration took [kg m^2/s]"},
    MeasureInfo{"spin_lost_outside", "what walls and forces took [kg m^2/s]"},
    MeasureInfo{"momentum", "size of the momentum [kg m/s]"},
    MeasureInfo{"newton", "Newton iterations of the last step"},
    MeasureInfo{"newton_most", "the most of any step"},
    MeasureInfo{"newton_mean", "the mean of all steps"},
    MeasureInfo{"linear", "linear iterations of the last step"},
    MeasureInfo{"linear_sum", "linear iterations of all steps"},
    MeasureInfo{"residual", "relative residual at the last step's end"},
    MeasureInfo{"residual_first", "relative residual at its beginning"},
    MeasureInfo{"order", "observed order of its last iterations; 0: unknown"},
    MeasureInfo{"J_least", "least volume ratio since the start"},
    MeasureInfo{"J_now", "least volume ratio now"},
    MeasureInfo{"J_now_most", "largest volume ratio now"},
    MeasureInfo{"cfl", "cells that the fastest particle crossed in the last step"},
    MeasureInfo{"error", "rms error of the position, where the motion is known [m]"},
    MeasureInfo{"error_most", "the most since the start [m]"},
    MeasureInfo{"retries", "steps that were begun again"},
    MeasureInfo{"visits", "particle visits of all kernels: work free of any clock"},
    MeasureInfo{"cell", "grid spacing [m]"},
    MeasureInfo{"particles", "their number"},
    MeasureInfo{"lowest", "the lowest particle's y [m]"},
    MeasureInfo{"highest", "the highest particle's y [m]"},
    MeasureInfo{"leftmost", "the leftmost particle's x [m]"},
    MeasureInfo{"rightmost", "the rightmost particle's x [m]"},
    MeasureInfo{"pieces", "pieces of material that share no node"},
};

double spin_of(const Vec3& L) {
  return std::abs(L.x()) + std::abs(L.y()) > 0 ? L.norm() : L.z();
}

double order_of(const StepReport& report) {
  std::vector<double> r;
  for (const NewtonIteration& it : report.newton) r.push_back(it.residual);
  const std::size_t n = r.size();
  if (n < 3 || !(r[n - 1] > 0 && r[n - 1] < r[n - 2] && r[n - 2] < r[n - 3])) return 0;
  return std::log(r[n - 1] / r[n - 2]) / std::log(r[n - 2] / r[n - 3]);
}

}  // namespace

std::span<const MeasureInfo> measure_infos() {
  return infos;
}

void RunMeasures::add(const StepReport& report) {
  if (count_++ == 0) first_ = report;
  last_ = report;
  const double newton = report.newton.empty() ? 0 : static_cast<double>(report.newton.size()) - 1;
  most_newton_ = std::max(most_newton_, newton);
  sum_newton_ += newton;
  sum_linear_ += report.linear_iterations;
  if (report.error.known) most_error_ = std::max(most_error_, report.error.l2);
  most_total_ = std::max(most_total_, report.balance.total());
  most_kinetic_ = std::max(most_kinetic_, report.balance.kinetic);
  least_J_ = std::min(least_J_, report.min_J);
  retries_ += report.retries;
  const Work& w = report.work;
  visits_ += static_cast<double>(w.p2g + w.g2p + w.energy + w.gradient + w.tangent + w.hessian_product + w.diagonal +
                                 w.assembly);
  lost_transfer_ -= spin_of(report.angular.transfer);
  lost_time_ -= spin_of(report.angular.time_integration);
  lost_outside_ -= spin_of(report.angular.outside);
  if (const double order = order_of(report); order > 0) order_ = order;
}

Constants RunMeasures::values(const Scene& scene, const Snapshot* snapshot) const {
  const Balance &now = last_.balance, &then = first_.balance;
  const double steps = count_ > 0 ? static_cast<double>(count_) - 1 : 0;
  std::array<double, 4> bounds{INFINITY, -INFINITY, INFINITY, -INFINITY};
  if (snapshot != nullptr) {
    const auto d = static_cast<std::size_t>(snapshot->dimension);
    for (std::size_t p = 0; p < snapshot->particles; ++p) {
      const double x = snapshot->x[p * d], y = snapshot->x[p * d + 1];
      bounds = {std::min(bounds[0], y), std::max(bounds[1], y), std::min(bounds[2], x), std::max(bounds[3], x)};
    }
  }
  const BasisInfo* basis = find_basis(scene.grid.basis);
  const double pieces = snapshot != nullptr && basis != nullptr ? count_pieces(*snapshot, *basis) : 0;
  const std::array<double, infos.size()> numbers{
      last_.time,
      steps,
      last_.dt,
      now.kinetic,
      then.kinetic,
      most_kinetic_,
      now.elastic,
      now.potential,
      now.total(),
      then.total(),
      most_total_,
      spin_of(now.angular_momentum),
      spin_of(then.angular_momentum),
      lost_transfer_,
      lost_time_,
      lost_outside_,
      now.momentum.norm(),
      last_.newton.empty() ? 0 : static_cast<double>(last_.newton.size()) - 1,
      most_newton_,
      steps > 0 ? sum_newton_ / steps : 0,
      static_cast<double>(last_.linear_iterations),
      sum_linear_,
      last_.residual,
      last_.newton.empty() ? 0 : last_.newton.front().residual,
      order_,
      least_J_,
      last_.min_J,
      last_.max_J,
      last_.cfl,
      last_.error.l2,
      most_error_,
      retries_,
      visits_,
      scene.grid.spacing,
      snapshot ? static_cast<double>(snapshot->particles) : 0,
      bounds[0],
      bounds[1],
      bounds[2],
      bounds[3],
      pieces};
  Constants values;
  for (std::size_t k = 0; k < infos.size(); ++k) values.emplace_back(infos[k].name, numbers[k]);
  return values;
}

bool needs_snapshot(std::string_view expression) {
  constexpr std::array names{"particles", "lowest", "highest", "leftmost", "rightmost", "pieces"};
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return expression.find(name) != std::string_view::npos; });
}

double measured(std::string_view expression, const Constants& values) {
  return Expression::compile(expression, values, mask_none)(std::span<const double>());
}

std::string with_values(std::string_view text, const Constants& values) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('{', at), close = text.find('}', open);
    if (open == std::string_view::npos || close == std::string_view::npos) return result.append(text.substr(at));
    result.append(text.substr(at, open - at));
    std::string_view inside = text.substr(open + 1, close - open - 1), unit;
    // The last bar: || is an operator.
    if (const std::size_t bar = inside.rfind('|'); bar != std::string_view::npos && inside[bar - 1] != '|') {
      unit = inside.substr(bar + 1);
      inside = inside.substr(0, bar);
    }
    const double value = measured(inside, values);
    result += unit == "%" ? quantity(value, "", 3) + " %" : quantity(value, unit, 3);
    at = close + 1;
  }
  return result;
}

int count_pieces(const Snapshot& s, const BasisInfo& basis) {
  using Cell = std::array<long, 3>;  // the first node of the particles in it
  std::map<Cell, int> piece;         // -1: not reached yet
  const auto d = static_cast<std::size_t>(s.dimension);
  for (std::size_t p = 0; p < s.particles; ++p) {
    Cell cell{};
    for (std::size_t a = 0; a < d; ++a) cell[a] = std::lround(std::floor(s.x[p * d + a] / s.spacing - basis.offset));
    piece[cell] = -1;
  }
  const long reach = basis.nodes_per_axis - 1;
  int pieces = 0;
  for (auto& [start, found] : piece) {
    if (found >= 0) continue;
    std::vector<Cell> open{start};
    found = pieces;
    while (!open.empty()) {
      const Cell cell = open.back();
      open.pop_back();
      for (long k = d == 3 ? -reach : 0; k <= (d == 3 ? reach : 0); ++k)
        for (long j = -reach; j <= reach; ++j)
          for (long i = -reach; i <= reach; ++i) {
            const auto there = piece.find({cell[0] + i, cell[1] + j, cell[2] + k});
            if (there == piece.end() || there->second >= 0) continue;
            there->second = pieces;
            open.push_back(there->first);
          }
    }
    ++pieces;
  }
  return pieces;
}

}  // namespace pf::app
