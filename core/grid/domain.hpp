// Shape functions averaged over a particle's own domain (basis `gimp`, `quadratic_gimp`): the mean of N_i, and of its
// gradient, over the parallelepiped F_p l_0 about x_p, where l_0 is the cube that the particle stood for at first.
// Sampling at the centre alone leaves an error of quadrature that no finer grid makes smaller, once particles have
// moved through cells; domains tile the deformed body as they tiled it at first, so that this error goes
// (docs/accuracy.md).
#pragma once

#include <vector>

#include "core/bases/basis.hpp"
#include "core/grid/wide.hpp"
#include "core/types.hpp"

namespace pf {

/// Weights of a batch of particles with the same nodes, each node by itself (core/grid/dense_stencil.hpp): K^D means of
/// N, then as many of each component of the gradient per unit of s = x/dx. `t`: s - base, D lanes; `edge`: F l_0 / dx,
/// column-major, D * D lanes; only the first `count` lanes count.
///
/// Exact where the domain's edges lie along the axes: there the mean is the product of the axes' own. Another domain is
/// cut along each edge e that leaves its main axis into pieces whose way across it is short (one sixteenth of a cell in
/// 2D, one eighth in 3D), and each piece taken for the upright box that is as wide. All means keep sum N = 1,
/// sum x_i N_i = x_p, and the gradients are the derivatives with respect to x_p.
///
/// A domain may reach half a cell from its centre along every axis, or its nodes would be more than K; a larger one is
/// shrunk about its centre, `shrunk` counts them.
template <int D>
void domain_weights(const BasisInfo& basis, const Wide<lane_count<D>>* t, const Wide<lane_count<D>>* edge, int count,
                    Wide<lane_count<D>>* w, int& shrunk);

/// What domain_weights does, seen along one axis: the sum of its weights over the nodes of the other axes is
/// sum_q share_q mean of N over [s + at_q - width_q / 2, s + at_q + width_q / 2], all in cells.
struct DomainPiece {
  double at = 0, width = 0, share = 1;
};
/// `edge`: F l_0 / dx, column-major.
template <int D>
std::vector<DomainPiece> domain_pieces(const double* edge, int axis);

extern template std::vector<DomainPiece> domain_pieces<2>(const double*, int);
extern template std::vector<DomainPiece> domain_pieces<3>(const double*, int);
extern template void domain_weights<2>(const BasisInfo&, const Wide<4>*, const Wide<4>*, int, Wide<4>*, int&);
extern template void domain_weights<3>(const BasisInfo&, const Wide<8>*, const Wide<8>*, int, Wide<8>*, int&);

}  // namespace pf
