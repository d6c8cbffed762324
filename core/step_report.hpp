// What one step did: the numbers behind stats.csv, the plots and the messages.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace pf {

enum class StepStatus { accepted, cancelled, failed, finished };

/// One Newton iteration (THEORY T4).
struct NewtonIteration {
  double residual = 0;     ///< relative, T4's criterion, at the start of the iteration
  double energy = 0;       ///< incremental potential E [J]
  double step_length = 0;  ///< accepted by the line search, 0 when none was taken
  int linear_iterations = 0;
  double projected = 0;  ///< share of the nodes whose part of the Hessian was made positive semi-definite, 0 to 1
  bool residual_search = false;  ///< energy differences were lost in rounding: searched on the gradient's norm
};

/// Wall time by phase [ms].
struct PhaseTimes {
  double sort = 0, transfer = 0, assemble = 0, linear_solve = 0, line_search = 0, update = 0, diagnostics = 0;
  double total = 0;
};

/// Work counted in particle visits by kernel, and in multiply-adds of the linear solver beside its Hessian products:
/// deterministic, free of clock noise. Of all attempts at a step, the failed ones too.
struct Work {
  std::uint64_t p2g = 0, g2p = 0, energy = 0, gradient = 0, tangent = 0, hessian_product = 0;
  std::uint64_t diagonal = 0, assembly = 0;  ///< of the Hessian's diagonal blocks; of all its blocks
  std::uint64_t solver_operations = 0;       ///< in double precision: vectors, factors
  std::uint64_t stencil_operations = 0;      ///< in single precision: multigrid's stencil matrices
};

/// Sums over particles at the end of the step (INTERFACE, stats.csv).
struct Balance {
  double kinetic = 0, elastic = 0, potential = 0;  ///< [J]; potential = -sum m g.x
  Vec3 momentum = Vec3::Zero();                    ///< [kg m/s]
  Vec3 angular_momentum = Vec3::Zero();            ///< [kg m^2/s], about the origin; only z in 2D
  double total() const { return kinetic + elastic + potential; }
};

/// What strokes have done to the particles since the start of the run. What painting put in counts as negative.
struct StrokeSums {
  long count = 0;                ///< strokes that met some particles
  std::uint64_t cut = 0;         ///< particles taken away
  std::uint64_t painted = 0;     ///< particles that were given another material, each as often as it was
  double mass = 0;               ///< taken away [kg]
  double energy = 0;             ///< kinetic, elastic and potential, taken away [J]
  Vec3 momentum = Vec3::Zero();  ///< taken away [kg m/s]
};

/// How a step changed the angular momentum [kg m^2/s], by cause (THEORY T6).
struct AngularLedger {
  Vec3 transfer = Vec3::Zero();          ///< particles -> grid -> particles
  Vec3 time_integration = Vec3::Zero();  ///< by the scheme alone; backward Euler: dt sum_i v_i^{n+1} x (M v^n)_i
  Vec3 outside = Vec3::Zero();  ///< by torques about the origin: gravity, loads, walls, constraints, the mouse's spring
  Vec3 strokes = Vec3::Zero();  ///< by strokes before the step
};

/// How a step changed the energy of the particles [J], by cause: all entries add up to the change, to rounding. What
/// comes in is positive. Works are of the mean force of the step over its displacement.
struct EnergyLedger {
  bool known = false;                    ///< it was asked for (Simulation::set_ledger)
  double loads = 0;                      ///< tractions and body forces; gravity's is the potential energy's
  double boundary = 0;                   ///< walls, their friction, and constraints
  double mouse = 0;                      ///< the mouse's spring
  double time_integration = 0;           ///< mean forces over a step are no integrals along the way
  double to_grid = 0, to_particles = 0;  ///< the transfers
  double solver = 0;                     ///< what Newton's method left unbalanced
  double edits = 0;                      ///< what edits of the scene changed before the step
  double strokes = 0;                    ///< what cutting and painting changed before the step
  double sum() const {
    return loads + boundary + mouse + time_integration + to_grid + to_particles + solver + edits + strokes;
  }
};

struct ErrorNorms {
  bool known = false;  ///< the scene has an exact motion
  double l2 = 0, max = 0, velocity_l2 = 0, F_l2 = 0;
};

/// What decided the length of a step.
enum class StepLimit : std::uint8_t {
  fixed,      ///< time.step
  tolerance,  ///< the estimated error
  stability,  ///< an explicit step may not be longer
  newton,     ///< longer ones would take Newton's method too many iterations
  crossing,   ///< no particle shall cross more than a cell
  largest,    ///< the longest that the scene allows
  growth,     ///< it was short, and grows step by step
  landing,    ///< shortened, or stretched by a tenth, to end where the run does
  failure,    ///< a longer one did not work out
};
/// "tolerance", "stability", ...: as it stands in stats.csv.
constexpr const char* name_of(StepLimit limit) {
  constexpr const char* names[] = {"fixed",   "tolerance", "stability", "newton", "crossing",
                                   "largest", "growth",    "landing",   "failure"};
  return names[static_cast<std::size_t>(limit)];
}

/// What step control chose and why. Costs are counted work (core/work_weights.hpp) a second of simulated time.
struct ControlReport {
  bool adaptive = false;  ///< without, nothing below is filled in
  bool implicit = true;
  StepLimit limited_by = StepLimit::fixed;
  double error_rate = 0;      ///< estimated relative displacement error a unit of time [1/s]
  double explicit_limit = 0;  ///< the longest stable explicit step [s]; 0: not known
  double implicit_cost = 0;   ///< of implicit steps as long as the tolerance lets them be; 0: not known
  double explicit_cost = 0;   ///< of explicit steps; 0: not considered
  int given_up = 0;           ///< attempts at this step whose error was too large
};

struct StepReport {
  StepStatus status = StepStatus::accepted;
  long step = 0;    ///< index of the state that the report describes; 0 is the initial state
  double time = 0;  ///< [s]
  double dt = 0;    ///< of this step [s]
  std::vector<NewtonIteration> newton;
  double residual = 0;  ///< final relative value
  int linear_iterations = 0;
  Balance balance;
  AngularLedger angular;
  EnergyLedger energy;
  StrokeSums strokes;
  ErrorNorms error;
  double min_J = 1, max_J = 1;
  int active_nodes = 0;
  double cfl = 0;  ///< max |v_p| dt / dx
  ControlReport control;
  int retries = 0;        ///< how often the step was begun again with a smaller dt
  double grab_force = 0;  ///< magnitude of the mouse spring's force [N]
  PhaseTimes ms;
  Work work;
  std::vector<std::string> warnings;  ///< for the user: what happened, what was done
  std::string failure;                ///< status failed: which particle, why, what to try
};

}  // namespace pf
