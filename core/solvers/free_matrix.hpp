// The assembled Hessian as a sparse matrix of numbers, for solvers that factorise it.
#pragma once

#include <Eigen/SparseCore>

#include "core/solvers/linear_solver.hpp"

namespace pf {

/// The lower triangle of Q H Q + (I - Q) t: the free directions' part of H, and a size of its own elsewhere, so that
/// the matrix is as definite as H is. `H` is room to work in, kept between calls.
template <int D>
void free_matrix(const LinearProblem<D>& problem, BlockMatrix<D>& H, Eigen::SparseMatrix<double>& lower);

}  // namespace pf
