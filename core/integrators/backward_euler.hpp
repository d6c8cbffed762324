// Backward Euler (THEORY T4): x^ minimises E(x^), v^{n+1} = (x^ - x)/dt. First order, never unstable, damps what it
// cannot resolve: E/E0 = (1 + w^2 dt^2)^-n.
#pragma once

#include "core/energies/inertia.hpp"
#include "core/integrators/integrator.hpp"
#include "core/integrators/potential.hpp"

namespace pf {

template <int D>
class BackwardEuler final : public Integrator<D> {
 public:
  double stage() const override { return 1; }
  NewtonResult advance(const StepProblem<D>& problem) override;

 private:
  // Kept between steps for their memory alone.
  std::vector<Energy<D>*> terms_;
  InertiaVectors inertia_;
  PotentialVectors<D> potential_;
  NewtonVectors<D> newton_;
  Vector free_flight_, flight_, g_, change_;
};

}  // namespace pf
