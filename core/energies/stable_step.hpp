// How long an explicit step may be, from the grid's own highest frequency: dearer and sharper than explicit_limit().
#pragma once

#include <functional>

#include "core/energies/elastic.hpp"
#include "core/solvers/feasible_set.hpp"

namespace pf {

/// What becomes of node velocities between two explicit steps, on their way through the particles: they are averaged.
struct BetweenSteps {
  /// momentum = m S v (Transfer::carry); empty: S is the identity.
  std::function<void(const Vector& v, Vector& momentum)> carry;
  /// Transfer::stiffening.
  std::function<double(double s)> stiffening;
};

/// The longest stable step of symplectic Euler [s]: 2 / w_max, w_max^2 the largest eigenvalue of r(S) m^-1 K over the
/// nodes that `set` leaves free. K is the true Hessian at rest, m the lumped mass, r the stiffening: without averaging
/// Hughes' limit (1987, section 9.1); with it the step at which a mode begins to swing to the other side at every step,
/// v <- S v - dt m^-1 K u, u <- u + dt v with u = (-1)^n u_0. By Lanczos' method in the inner product
/// of (r(S) m^-1)^-1, r by a Chebyshev series, to about one per cent: some 20 Hessian products and 3 to 8 averages
/// each. Infinity where nothing is stiff.
template <int D>
double stable_step(ElasticEnergy<D>& elastic, const Vector& mass, const FeasibleSet<D>& set,
                   const BetweenSteps& between = {});

extern template double stable_step<2>(ElasticEnergy<2>&, const Vector&, const FeasibleSet<2>&, const BetweenSteps&);
extern template double stable_step<3>(ElasticEnergy<3>&, const Vector&, const FeasibleSet<3>&, const BetweenSteps&);

}  // namespace pf
