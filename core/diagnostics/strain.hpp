// Measures of deformation that people look at, defined once. Of a full 3 x 3 deformation gradient F; in 2D F_33 = 1
// (THEORY T1).
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/types.hpp"

namespace pf {

/// Eigenvalues of a symmetric tensor, the largest first.
template <int D>
Vec<D> principal_values(const Mat<D>& S) {
  Eigen::SelfAdjointEigenSolver<Mat<D>> solver;
  solver.computeDirect(S, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().reverse();
}

/// Principal stretches, the largest first: singular values of F.
template <int D>
Vec<D> principal_stretches(const Mat<D>& F) {
  return principal_values<D>(F.transpose() * F).cwiseMax(0).cwiseSqrt();
}

/// Green's strain E = (F^T F - I)/2: 0 under rotations.
template <int D>
Mat<D> green_strain(const Mat<D>& F) {
  return 0.5 * (F.transpose() * F - Mat<D>::Identity());
}

/// sqrt(2/3 e:e) with e the deviator of Hencky's strain ln V, in three dimensions: what a stretched bar of constant
/// volume has as ln of its stretch.
template <int D>
double equivalent_strain(const Mat<D>& F) {
  Vec3 e = Vec3::Zero();
  e.template head<D>() = principal_stretches<D>(F).cwiseMax(1e-300).array().log().matrix();
  e.array() -= e.mean();
  return std::sqrt(2.0 / 3) * e.norm();
}

}  // namespace pf
