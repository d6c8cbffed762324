// How long an explicit step may be: 2 over the highest frequency of the lumped grid, from above.
#pragma once

#include "core/energies/elastic.hpp"

namespace pf {

/// The longest stable step of symplectic Euler with the lumped mass at the particles' present deformation [s]; infinity
/// where nothing is stiff. Counted as one tangent a particle.
///
/// w^2 M <= K over the grid if it holds for every particle's share of both (Irons and Treharne 1971): with
/// M_p = m_p diag(N_i) and a wave along axis c the share's eigenvalue is sum_i (dN_i/dx_c)^2 / N_i times the acoustic
/// tensor V_p^0 (F_n A F_n^T)_{.c.c} / m_p. The sum is taken where it is largest (particles move through the cell),
/// 6/dx^2 for quadratic splines; for linear shape functions, where it has no bound, at an eighth of a cell from a node.
template <int D>
double explicit_limit(const Plan<D>& plan, const Particles<D>& particles, const Laws<D>& laws, Parallel& parallel,
                      Work& work);

extern template double explicit_limit<2>(const Plan<2>&, const Particles<2>&, const Laws<2>&, Parallel&, Work&);
extern template double explicit_limit<3>(const Plan<3>&, const Particles<3>&, const Laws<3>&, Parallel&, Work&);

}  // namespace pf
