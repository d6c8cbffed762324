// TR-BDF2 (Bank et al. 1985; Hosea and Shampine 1996): the trapezoidal rule to t + g dt, g = 2 - sqrt 2, then the
// second-order backward difference to t + dt:
//     M (v_g - v) = g dt/2 (f_0 + f_g),                 u_g = g dt/2 (v + v_g)
//     M (v_1 - [v_g - (1-g)^2 v]/(g(2-g))) = k f_1,     u   = u_g/(g(2-g)) + k v_1,     k = (1-g)/(2-g) dt.
// Second order and L-stable: it follows what the step resolves without loss and damps what it cannot. Two solves a
// step, with the same matrix (g/2 = (1-g)/(2-g)). Every stage deforms the particles from their state at t^n: the last
// one's stresses are those of the return map of the whole step's trial, the stage at g leaves nothing behind
// (integrator.hpp).
#pragma once

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
class TrBdf2 final : public Integrator<D> {
 public:
  std::vector<ForcePart> parts(double) const override;
  StepResult advance(const StepProblem<D>& problem) override;

 private:
  // Kept between steps for their memory alone.
  StageMemory<D> memory_;
  StartForces start_;
  Vector u_free_, loads_;
};

}  // namespace pf
