// How long an explicit step may be, from the grid's own highest frequency: dearer and sharper than explicit_limit().
#pragma once

#include "core/energies/elastic.hpp"
#include "core/solvers/feasible_set.hpp"

namespace pf {

/// 2 / w_max [s], w_max^2 the largest eigenvalue of m^-1 K over the nodes that `set` leaves free, K the true Hessian at
/// rest and m the lumped mass: beyond it symplectic Euler grows (Hughes 1987, section 9.1). By Lanczos' method to about
/// one per cent: some 20 Hessian products. Infinity where nothing is stiff. What transfers do between two steps is left
/// out: measured limits are up to an eighth lower with APIC and 20 to 30 % with FLIP (docs/failures.md).
template <int D>
double stable_step(ElasticEnergy<D>& elastic, const Vector& mass, const FeasibleSet<D>& set);

extern template double stable_step<2>(ElasticEnergy<2>&, const Vector&, const FeasibleSet<2>&);
extern template double stable_step<3>(ElasticEnergy<3>&, const Vector&, const FeasibleSet<3>&);

}  // namespace pf
