// Generalised-alpha (Chung and Hulbert 1993) with inner forces at the interpolated displacement:
//     M [(1-am) a^{n+1} + am a^n] = f(x + (1-af) u) at t + (1-af) dt
//     u = dt v^n + dt^2 [(1/2 - b) a^n + b a^{n+1}],     v^{n+1} = v^n + dt [(1-c) a^n + c a^{n+1}]
//     am = (2r-1)/(r+1),  af = r/(r+1),  c = 1/2 - am + af,  b = (1 - am + af)^2/4.
// Second order; r, the spectral radius, says how much of the fastest waves a step leaves: 1 all (midpoint's forces), 0
// nothing. It needs the acceleration of the step before: particles carry it, a_p += sum_j (a_j^{n+1} - a_j^n) N_j, and
// give it to the nodes as they give velocities (lumped, FMPM or consistent). Increments whatever the velocities'
// transfer, since what a filter would take of it at every step is an error that no dt makes smaller. The first step
// finds it from M a = f. Stresses are those of F at (1-af) u; of an inelastic law, those of its return map there
// (integrator.hpp). F is extrapolated from there to u by 1 + r.
#pragma once

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
class GeneralizedAlpha final : public Integrator<D> {
 public:
  explicit GeneralizedAlpha(double spectral_radius) : r_(spectral_radius) {}
  bool carries_acceleration() const override { return true; }
  std::vector<ForcePart> parts(double) const override { return {{1, 1 - r_ / (r_ + 1), 0, 0}}; }
  StepResult advance(const StepProblem<D>& problem) override;

 private:
  NewtonResult start_acceleration(const StepProblem<D>& problem) const;

  double r_;
  // Kept between steps for their memory alone.
  StageMemory<D> memory_;
  Vector u_free_, loads_;
};

}  // namespace pf
