// One step, taken apart: what the grid did between t^n and t^{n+1}, iterate by iterate (THEORY T3 to T5). A plain
// value, made only on request (Simulation::set_recording); recording changes no bit of the step.
#pragma once

#include <cstdint>
#include <vector>

#include "core/step_report.hpp"

namespace pf {

/// What is kept of every step from now on.
enum class RecordLevel {
  none,       ///< nothing, at no cost
  residuals,  ///< where in space each iterate's residual is largest, and the residual that the last one left
  all,        ///< everything below
};

/// An implicit stage: at its minimum  scale M (u - u_free) - f_int(x + u) - given = 0  but for what holds the nodes.
struct StageRecord {
  double scale = 0;            ///< [1/s^2]; 1/dt^2 for backward Euler, 0 without inertia
  std::vector<double> u_free;  ///< where the nodes would go without forces: dt v^n for backward Euler [m]
  std::vector<double>
      given;  ///< forces that do not depend on u: f_ext, and those of an earlier time that it weighs [N]
};

/// An iterate of Newton's method. Vectors have `dimension` components a node; empty at RecordLevel::residuals, but for
/// the residual of the last iterate.
struct IterateRecord {
  std::size_t stage = 0;         ///< into StepRecord::stages
  NewtonIteration newton;        ///< as in the report
  std::vector<double> u;         ///< x^_i - x_i, of the stage [m]
  std::vector<double> inertia;   ///< scale M (u - u_free) [N]
  std::vector<double> internal;  ///< f_int(x + u) [N]
  std::vector<double> residual;  ///< what of dE/du no constraint, wall or friction takes [N]
  std::int32_t worst = -1;       ///< the node with most of the residual, weighed as in T4; -1: there is none
  double worst_share = 0;        ///< its part of the squared norm, 0 to 1
};

struct StepRecord {
  int dimension = 2;
  double spacing = 0;                                  ///< dx [m]
  long step = 0;                                       ///< index of the state that the step led to
  double time = 0;                                     ///< t^n [s]
  double dt = 0;                                       ///< [s]
  bool accepted = false;                               ///< else the newest attempt: u, v_end and `after` may be missing
  std::vector<std::int32_t> node_index;                ///< lattice coordinates; x_i = dx * index
  std::vector<double> node_mass;                       ///< m_i [kg]
  std::vector<double> node_velocity;                   ///< v_i^n, as particles gave it [m/s]
  std::vector<double> internal_start, external_start;  ///< f_int(x), f_ext(t^n) [N]
  std::vector<StageRecord> stages;                     ///< none in an explicit step
  std::vector<IterateRecord> iterates;                 ///< none in an explicit step
  std::vector<double> node_displacement;               ///< x^_i - x_i [m]
  std::vector<double> node_velocity_end;               ///< v_i^{n+1} [m/s]

  /// Particles at t^n and t^{n+1}, both in the order that they had at t^n; F column-major.
  struct ParticleArrays {
    std::vector<double> x, v, F;
  };
  std::vector<std::uint32_t> id;
  std::vector<double> particle_mass;
  ParticleArrays before, after;

  /// The weights that the step used, averaged over domains and ended at walls where its are: nodes_per_axis^dimension
  /// nodes a particle, x fastest, from its first one on; of each node w_ip and grad w_ip [1/m].
  int nodes_per_axis = 0;
  std::vector<std::int32_t> first_node;  ///< lattice coordinates
  std::vector<float> weights;            ///< 1 + dimension a node

  std::size_t nodes() const { return node_mass.size(); }
};

}  // namespace pf
