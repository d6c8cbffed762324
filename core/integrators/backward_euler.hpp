// Backward Euler (THEORY T4): x^ minimises E(x^), v^{n+1} = (x^ - x)/dt. First order, never unstable, damps what it
// cannot resolve: E/E0 = (1 + w^2 dt^2)^-n.
#pragma once

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
class BackwardEuler final : public Integrator<D> {
 public:
  StepResult advance(const StepProblem<D>& problem) override;

 private:
  // Kept between steps for their memory alone.
  StageMemory<D> memory_;
  Vector u_free_, loads_;
};

}  // namespace pf
