// A time scheme: what it asks the solver to minimise, and which velocity the grid has afterwards.
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <string_view>

#include "core/energies/elastic.hpp"
#include "core/energies/friction.hpp"
#include "core/energies/grab.hpp"
#include "core/grid/mass.hpp"
#include "core/solvers/newton.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

/// What one step on the grid works with. All parts outlive the call.
template <int D>
struct StepProblem {
  const Plan<D>& plan;
  const MassMatrix<D>& mass;  ///< the inertia's
  ElasticEnergy<D>& elastic;
  GrabSpring<D>* grab;  ///< may be null
  FeasibleSet<D>& set;  ///< constraints and boundaries, displacements over dt; in and out: the friction bounds
  const Vector& force;  ///< f_ext at the scheme's stage time [N]
  double dt;
  NewtonSettings newton;
  LinearSolver<D>& linear;
  Parallel& parallel;
  const std::atomic<bool>* cancel;
  GridState<D>& grid;            ///< in: mass, v; out: u, v_end
  double kick = 0;               ///< explicit: how long forces change the velocities [s] (StepChoice); 0: dt
  double* error_rate = nullptr;  ///< out, where it is wanted: the local error in position, rms over mass, over dt [m/s]
};

template <int D>
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Time at which loads are evaluated, as a fraction of the step: 1 for backward Euler, 0 for symplectic Euler.
  virtual double stage() const = 0;
  virtual NewtonResult advance(const StepProblem<D>& problem) = 0;
};

struct IntegratorInfo {
  std::string_view name, label, about;
  bool implicit;
};
std::span<const IntegratorInfo> integrators();
/// Throws std::invalid_argument for an unknown name.
template <int D>
std::unique_ptr<Integrator<D>> make_integrator(std::string_view name);

}  // namespace pf
