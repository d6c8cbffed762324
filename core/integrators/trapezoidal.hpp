// The trapezoidal rule (Newmark 1/4, 1/2 from exact accelerations): M (v^{n+1} - v^n) = dt/2 (f^n + f^{n+1}),
// u = dt/2 (v^n + v^{n+1}). Second order, no damping; nothing is extrapolated, so what a law with a barrier allows is
// what the particles get. f^n is computed on this step's grid from the particles' state at t^n, whose stresses an
// inelastic law has returned already; f^{n+1} sees the return map of its own trial (integrator.hpp). Friction acts with
// the force of the step's end, as in backward Euler.
#pragma once

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
class Trapezoidal final : public Integrator<D> {
 public:
  std::vector<ForcePart> parts(double) const override { return {{0.5, 0, 0}, {0.5, 1, 1}}; }
  StepResult advance(const StepProblem<D>& problem) override;

 private:
  // Kept between steps for their memory alone.
  StageMemory<D> memory_;
  StartForces start_;
  Vector u_free_, loads_;
};

}  // namespace pf
