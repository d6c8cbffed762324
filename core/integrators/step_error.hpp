// The error that an implicit step makes in position, estimated from what the step has at hand.
#pragma once

#include "core/integrators/integrator.hpp"
#include "core/solvers/objective.hpp"

namespace pf {

/// Root mean square over the nodes' mass of the local error in position of a backward Euler step, over dt [m/s].
///
/// e = dt (v^{n+1} - v^n) / 2 is the difference between its displacement dt v^{n+1} and the trapezoidal dt (v^n +
/// v^{n+1}) / 2, which is of second order. Where the material is stiff that is too much: the body springs back to where
/// its forces balance. What is left of e after that, (M/dt^2 + K) e' = M e/dt^2 (Shampine and Baca 1984), is too
/// little: a fast vibration is gone without a trace. The result is the geometric mean of the two: of a vibration with w
/// dt >> 1 and speed v just half its amplitude v/w, which is what the step takes away; for w dt << 1 both are e.
///
/// e' by three iterations of conjugate gradients with the Hessian of the last Newton iteration; `has_hessian` tells
/// whether there was one. Nodes that a constraint or a wall holds are left out: they follow it, not the integrator.
template <int D>
double step_error_rate(Objective<D>& objective, const StepProblem<D>& problem, bool has_hessian);

extern template double step_error_rate<2>(Objective<2>&, const StepProblem<2>&, bool);
extern template double step_error_rate<3>(Objective<3>&, const StepProblem<3>&, bool);

}  // namespace pf
