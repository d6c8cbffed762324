// Which linear solver "auto" means in the next step: counted work, never a clock, so that a run can be repeated.
#include <algorithm>
#include <cstdio>

#include "core/step/simulation_of.hpp"

namespace pf {

namespace {

/// Measured (docs/performance.md): iterations of block-Jacobi for each cell that a pressure wave crosses in a step, and
/// how many iterations a solve pay for multigrid's matrices.
constexpr double iterations_a_cell = 2.6;
constexpr double worth_multigrid = 40, worth_direct = 150, no_longer_worth = 25;
constexpr int most_direct_nodes = 30000;
/// With fewer nodes multigrid has nothing to gain: at 12 thousand both were still as fast as each other.
constexpr int least_multigrid_nodes = 4000;

std::string text(const char* format, double value) {
  char line[200];
  std::snprintf(line, sizeof line, format, value);
  return line;
}

}  // namespace

template <int D>
double SimulationOf<D>::expected_iterations(double dt) const {
  double speed = 0;
  for (std::size_t k = 0; k < laws_.size(); ++k)
    speed = std::max(speed, laws_[k]->wave_speed(scene_.materials[k].density));
  std::array<long long, D> low, high;
  low = high = plan_.node_index(0);
  for (const std::array<long long, D>& i : plan_.node_indices())
    for (std::size_t a = 0; a < D; ++a) {
      low[a] = std::min(low[a], i[a]);
      high[a] = std::max(high[a], i[a]);
    }
  long long extent = 0;
  for (std::size_t a = 0; a < D; ++a) extent = std::max(extent, high[a] - low[a]);
  return iterations_a_cell * std::min(speed * dt / scene_.grid.spacing, static_cast<double>(extent));
}

template <int D>
std::string SimulationOf<D>::automatic_solver(double dt) {
  const auto solves = static_cast<int>(accepted_.newton.size()) - 1;
  const double each = solves > 0 ? static_cast<double>(accepted_.linear_iterations) / solves : 0;
  const bool counted = solves > 0 && chosen_solver_ == "pcg_jacobi";
  const double expected = counted ? each : expected_iterations(dt);
  const bool small = D == 2 && plan_.node_count() < most_direct_nodes;
  if (chosen_solver_ == "direct" && small) {
    choice_reason_ = text("block-Jacobi took more than %.0f iterations a solve", worth_direct);
    return "direct";
  }
  if (chosen_solver_ == "pcg_multigrid" && (each >= 4 || expected > no_longer_worth)) {
    choice_reason_ = text("its matrices still pay: %.1f iterations a solve were counted", each);
    return chosen_solver_;
  }
  choice_reason_ = text(counted ? "%.0f iterations a solve of block-Jacobi were counted"
                                : "about %.0f iterations a solve of block-Jacobi are expected of waves this fast",
                        expected);
  if (small && expected > worth_direct) return "direct";
  return expected > worth_multigrid && plan_.node_count() >= least_multigrid_nodes ? "pcg_multigrid" : "pcg_jacobi";
}

template <int D>
void SimulationOf<D>::choose_solver(double dt) {
  std::string name = scene_.solver.linear;
  choice_reason_.clear();
  if (name == "auto") name = automatic_solver(dt);
  if (grab_ && name == "direct") {
    name = "pcg_jacobi";
    choice_reason_ = "the mouse's spring couples nodes beyond the direct solver's pattern";
  }
  if (!linear_ || linear_->name() != name) linear_ = make_linear_solver<D>(name, parallel_);
  chosen_solver_ = name;
}

template double SimulationOf<2>::expected_iterations(double) const;
template double SimulationOf<3>::expected_iterations(double) const;
template std::string SimulationOf<2>::automatic_solver(double);
template std::string SimulationOf<3>::automatic_solver(double);
template void SimulationOf<2>::choose_solver(double);
template void SimulationOf<3>::choose_solver(double);

}  // namespace pf
