// Which linear solver "auto" means in the next step: counted work, never a clock, so that a run can be repeated.
#include <algorithm>
#include <cstdio>

#include "core/step/simulation_of.hpp"

namespace pf {

namespace {

/// Measured (docs/performance.md), in iterations of block-Jacobi: how many each cell takes that a pressure wave crosses
/// in a step; in 2D and 3D, what multigrid's matrices cost, and one of its iterations.
constexpr double iterations_a_cell = 2.6;
constexpr double cost_of_matrices[] = {17, 41}, cost_of_cycle[] = {3.4, 2.7};
/// A solve by multigrid, before one has been counted; by factors.
constexpr double worth_multigrid = 40, worth_direct = 150;
/// What leads to multigrid must save so much; what leads away, anything.
constexpr double gain = 1.3;
/// Steps with multigrid until block-Jacobi is counted again, unless it took more than so many times as much.
constexpr int steps_to_trial = 30;
constexpr double hopeless = 4;
constexpr int most_direct_nodes = 30000;
/// With fewer nodes multigrid has nothing to gain.
constexpr int least_multigrid_nodes[] = {500, 4000};

/// Replaces `to`, whose memory serves again.
template <class... Values>
void print(std::string& to, const char* format, Values... values) {
  char line[200];
  std::snprintf(line, sizeof line, format, values...);
  to = line;
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
void SimulationOf<D>::count_solves(const StepReport& report) {
  const auto solves = static_cast<double>(report.newton.size()) - 1;
  if (!(solves > 0)) return;
  solves_.solver = chosen_solver_;
  const double iterations = report.linear_iterations;
  if (chosen_solver_ == "pcg_jacobi") {
    solves_.jacobi = iterations / solves;
    solves_.steps = 0;
  }
  if (chosen_solver_ == "pcg_multigrid") {
    const double matrices = static_cast<double>(report.work.assembly) / static_cast<double>(particles_.size());
    solves_.multigrid = (matrices * cost_of_matrices[D - 2] + iterations * cost_of_cycle[D - 2]) / solves;
    ++solves_.steps;
  }
}

template <int D>
std::string SimulationOf<D>::automatic_solver(double dt) {
  const bool counted = solves_.jacobi > 0;
  const double jacobi = counted ? solves_.jacobi : expected_iterations(dt);
  const double multigrid = solves_.multigrid > 0 ? solves_.multigrid : worth_multigrid;
  const bool coarsens = plan_.node_count() >= least_multigrid_nodes[D - 2];
  const bool small = D == 2 && plan_.node_count() < most_direct_nodes;
  if (small && (solves_.solver == "direct" || std::min(jacobi, coarsens ? multigrid : jacobi) > worth_direct)) {
    print(choice_reason_, "iterations would be more than %.0f a solve", worth_direct);
    return "direct";
  }
  if (solves_.solver == "pcg_multigrid" && coarsens) {
    const bool trial = solves_.steps >= steps_to_trial && (!counted || jacobi < hopeless * multigrid);
    if (!trial && multigrid < jacobi) {
      print(choice_reason_,
            counted ? "a solve costs as much as %.0f iterations of block-Jacobi, which took %.0f"
                    : "a solve costs as much as %.0f iterations of block-Jacobi, of which about %.0f are expected",
            multigrid, jacobi);
      return solves_.solver;
    }
  } else if (coarsens && jacobi > gain * multigrid) {
    print(choice_reason_,
          counted ? "block-Jacobi took %.0f iterations a solve"
                  : "of block-Jacobi about %.0f iterations a solve are expected with waves this fast",
          jacobi);
    return "pcg_multigrid";
  }
  print(choice_reason_,
        counted ? "block-Jacobi took %.0f iterations a solve"
                : "of block-Jacobi about %.0f iterations a solve are expected with waves this fast",
        jacobi);
  return "pcg_jacobi";
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
template void SimulationOf<2>::count_solves(const StepReport&);
template void SimulationOf<3>::count_solves(const StepReport&);
template std::string SimulationOf<2>::automatic_solver(double);
template std::string SimulationOf<3>::automatic_solver(double);
template void SimulationOf<2>::choose_solver(double);
template void SimulationOf<3>::choose_solver(double);

}  // namespace pf
