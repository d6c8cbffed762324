// Implicit midpoint: a backward Euler step of dt/2 and its extrapolation, x^ = x + 2 u_mid, v^{n+1} = 2 v_mid - v^n.
// Second order, E/E0 = 1: it damps nothing, waves that the step cannot follow included. What is extrapolated may turn
// material inside out; the step is then taken again with a smaller dt, as after any other failure.
// Stresses are those of F at the middle; of an inelastic law, those of its return map there (integrator.hpp).
#pragma once

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
class ImplicitMidpoint final : public Integrator<D> {
 public:
  double force_place() const override { return 0.5; }
  std::vector<ForcePart> parts(double) const override { return {{1, 0.5, 0.5}}; }
  StepResult advance(const StepProblem<D>& problem) override;

 private:
  // Kept between steps for their memory alone.
  StageMemory<D> memory_;
  Vector u_free_, loads_, u_;
};

}  // namespace pf
