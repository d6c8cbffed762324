// Symplectic (explicit) Euler: v^{n+1} = v^n + dt M^-1 f(x^n), x^ = x + dt v^{n+1}. Cheap and without damping, stable
// only below a dt of about dx/c. With a kick of its own (half of the step before and half of this one) its velocities
// stand half a step before its places: leapfrog, of second order.
#pragma once

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
class SymplecticEuler final : public Integrator<D> {
 public:
  double force_place() const override { return 0; }
  std::vector<ForcePart> parts(double kick) const override { return {{kick, 0, 0}}; }
  StepResult advance(const StepProblem<D>& problem) override;

 private:
  // Kept between steps for their memory alone.
  StartForces start_;
  Vector force_, a_, before_;
};

}  // namespace pf
