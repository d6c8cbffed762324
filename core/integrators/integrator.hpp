// A time scheme: what it asks the solver to minimise, and which velocity the grid has afterwards.
//
// A step has one or more stages, at each of which forces are evaluated. Every stage deforms the particles from their
// state at t^n: the trial F^ F^{e,n} of an inelastic law starts from the elastic part that the last step left, at each
// stage afresh, and is returned to the yield surface there; what a stage returned is forgotten. The state changes once,
// at the step's end, when the whole F^ is returned (THEORY T3, T5). Midpoint and generalised-alpha extrapolate beyond
// their stage: the end's stress is admissible, too, but the balance was met by the stage's.
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <string_view>

#include "core/energies/elastic.hpp"
#include "core/energies/friction.hpp"
#include "core/energies/grab.hpp"
#include "core/grid/mass.hpp"
#include "core/integrators/step_observer.hpp"
#include "core/solvers/newton.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

/// What forces gave the nodes while they stood at x + u: there inner forces have no torque.
struct StageImpulse {
  Vector u;        ///< [m]
  Vector impulse;  ///< [N s]
};

/// One evaluation of the forces whose weighted mean over the step changes the velocities.
struct ForcePart {
  double weight;    ///< in the mean; all add up to 1 (an explicit step with a kick: to kick / dt)
  double fraction;  ///< of dt, when the loads were taken
  double place;     ///< where the nodes stood, as a part of the step's displacement
  int stage = -1;   ///< or there where this one of StepResult::impulses did
};

/// What a stage asks of the scene.
template <int D>
class StepConditions {
 public:
  virtual ~StepConditions() = default;
  /// f_ext at t + fraction dt [N].
  virtual void force(double fraction, Vector& f) = 0;
  /// Constraints and boundaries over the first part of the step.
  virtual FeasibleSet<D> set_of_part(double fraction) = 0;
};

/// What one step on the grid works with. All parts outlive the call.
template <int D>
struct StepProblem {
  const Plan<D>& plan;
  const MassMatrix<D>& mass;  ///< the inertia's
  ElasticEnergy<D>& elastic;
  GrabSpring<D>* grab;  ///< may be null
  FeasibleSet<D>& set;  ///< constraints and boundaries, displacements over dt; in and out: the friction bounds
  StepConditions<D>& conditions;
  double dt;
  NewtonSettings newton;
  LinearSolver<D>& linear;
  Parallel& parallel;
  const std::atomic<bool>* cancel;
  GridState<D>& grid;            ///< in: mass, v, perhaps a; out: u, v_end, perhaps a_end
  double kick = 0;               ///< explicit: how long forces change the velocities [s] (StepChoice); 0: dt
  double* error_rate = nullptr;  ///< out, where it is wanted: the local error in position, rms over mass, over dt [m/s]
  StepObserver* observer = nullptr;  ///< looks on; may be null
  Energy<D>* ties = nullptr;         ///< of light nodes; may be null
};

/// How a step on the grid ended.
struct StepResult {
  NewtonResult newton;
  /// Where the step's forces acted; empty: all at x + force_place() u.
  std::vector<StageImpulse> impulses;
};

template <int D>
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Where the forces act that make v_end of v, as a part of the step's displacement: 1 for backward Euler, 0 for
  /// symplectic Euler; for the ledger of angular momentum.
  virtual double force_place() const { return 1; }
  /// What M (v_end - v) / dt is the sum of, but for what holds the nodes; `kick`: over dt, of an explicit step.
  virtual std::vector<ForcePart> parts(double /*kick*/) const { return {{1, 1, 1}}; }
  /// Whether particles carry an acceleration from step to step (GridState::a).
  virtual bool carries_acceleration() const { return false; }
  virtual StepResult advance(const StepProblem<D>& problem) = 0;
};

struct IntegratorInfo {
  std::string_view name, label, about;
  bool implicit;
  bool inertia = true;    ///< false: equilibrium at every step
  bool adaptive = false;  ///< step control knows its error
  int order = 1;          ///< of convergence in dt, where the motion is smooth
};
std::span<const IntegratorInfo> integrators();
/// nullptr for an unknown name.
const IntegratorInfo* find_integrator(std::string_view name);
/// `spectral_radius`: of generalised-alpha, 0 to 1. Throws std::invalid_argument for an unknown name.
template <int D>
std::unique_ptr<Integrator<D>> make_integrator(std::string_view name, double spectral_radius = 0.8);

}  // namespace pf
