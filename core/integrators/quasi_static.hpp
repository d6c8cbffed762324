// Quasi-static steps (THEORY T7): equilibrium at every t^{n+1}, the potential without its inertia. Time is a load
// parameter; v = u/dt is reported, kinetic energy is 0 and the transfer plays no part (its velocities are only a guess
// of where to start). An inelastic law sees the increment's own trial, as in backward Euler.
#pragma once

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
class QuasiStatic final : public Integrator<D> {
 public:
  StepResult advance(const StepProblem<D>& problem) override;

 private:
  // Kept between steps for their memory alone.
  StageMemory<D> memory_;
  Vector u_free_, loads_;
};

}  // namespace pf
