// Checks that every term of the incremental potential must pass: value, gradient, Hessian and its three forms agree.
#pragma once

#include <doctest/doctest.h>

#include "core/integrators/potential.hpp"
#include "tests/numerics.hpp"

namespace pf::test {

inline constexpr double stored_tangents = 0x1p-23;  ///< Newton's matrix is in single precision

/// f(dimension, law, basis) for every law and basis in both dimensions.
template <class F>
void for_all(F&& f) {
  for (const LawInfo& law : laws())
    for (const BasisInfo& basis : bases()) {
      CAPTURE(law.name);
      CAPTURE(basis.name);
      f(std::integral_constant<int, 2>{}, law, basis);
      f(std::integral_constant<int, 3>{}, law, basis);
    }
}

/// The lower triangle written out as a full symmetric matrix.
template <int D>
Eigen::MatrixXd dense(const BlockMatrix<D>& H) {
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(H.rows() * D, H.rows() * D);
  for (int row = 0; row < H.rows(); ++row)
    for (auto k = H.row_start[static_cast<std::size_t>(row)]; k < H.row_start[static_cast<std::size_t>(row) + 1]; ++k) {
      const int column = H.column[static_cast<std::size_t>(k)];
      const Mat<D>& B = H.block[static_cast<std::size_t>(k)];
      full.template block<D, D>(row * D, column * D) = B;
      full.template block<D, D>(column * D, row * D) = B.transpose();
    }
  return full;
}

template <int D>
Vector gradient_of(Energy<D>& energy, const Vector& u) {
  Vector g = Vector::Zero(u.size()), magnitude = Vector::Zero(u.size() / D);
  energy.gradient(u, g, magnitude);
  return g;
}

/// Forces at x_i + u_i sum to nothing and, if the law is `objective`, turn nothing (about z).
template <int D>
void check_balance(const Plan<D>& plan, const Vector& u, const Vector& g, bool objective) {
  Vec<D> force = Vec<D>::Zero();
  double torque = 0;
  for (int i = 0; i < plan.node_count(); ++i) {
    const Vec<D> x = plan.node_position(i) + u.segment<D>(i * D), f = g.segment<D>(i * D);
    force += f;
    torque += x[0] * f[1] - x[1] * f[0];
  }
  CHECK(force.norm() < 1e-12 * g.template lpNorm<1>());
  if (objective) CHECK(std::abs(torque) < 1e-12 * g.template lpNorm<1>());
}

/// Central differences with step h are off by O(h^2): a quarter at half the step, down to rounding: that of the
/// differences, and `exactness`, that of what they are compared with.
inline void check_second_order(double error, double half_error, double size, double h, double exactness = 0) {
  const double rounding = 1e-12 * size / h + exactness;
  CHECK(error < 0.05 * size + rounding);
  CHECK((half_error < 0.35 * error || half_error < rounding));
}

/// dE/du against E and H p against dE/du along random directions, `h` [m] small against what u may do. H p is as exact
/// as the numbers that make up H, to `hessian_rounding`.
template <int D>
void check_derivatives(Energy<D>& energy, const Vector& u, double h, double hessian_rounding = 0) {
  Random random(31);
  for (int k = 0; k < 3; ++k) {
    const Vector p = random.values(u.size(), 1);
    const double E = energy.value(u);
    REQUIRE(std::isfinite(E));
    const Vector g = gradient_of(energy, u);
    Vector ignored = Vector::Zero(u.size()), magnitude = Vector::Zero(u.size() / D);
    CHECK(energy.gradient(u, ignored, magnitude) == doctest::Approx(E).epsilon(1e-13));
    const auto slope_error = [&](double s) {
      return std::abs((energy.value(u + s * p) - energy.value(u - s * p)) / (2 * s) - g.dot(p));
    };
    check_second_order(slope_error(h), slope_error(h / 2), std::abs(E) / h + g.norm() * p.norm(), h);

    const auto difference = [&](double s) -> Vector {
      return (gradient_of(energy, u + s * p) - gradient_of(energy, u - s * p)) / (2 * s);
    };
    const Vector at_h = difference(h), at_half = difference(h / 2);
    gradient_of(energy, u);
    energy.prepare_hessian(u, false);
    Vector Hp = Vector::Zero(u.size());
    energy.hessian_product(p, Hp);
    check_second_order((at_h - Hp).norm(), (at_half - Hp).norm(), Hp.norm() + g.norm() / h * 1e-3, h,
                       hessian_rounding * Hp.norm());
  }
}

/// Product, assembled matrix and diagonal blocks of one Hessian; `projected`: it has no negative eigenvalue.
template <int D>
void check_forms(Energy<D>& energy, const Grid<D>& grid, const Vector& u, bool project) {
  const FeasibleSet<D> free;
  IncrementalPotential<D> potential(grid.plan, grid.state.mass, free, {&energy}, {});
  gradient_of(energy, u);
  potential.prepare_hessian(u, project);
  BlockMatrix<D> H;
  potential.assemble(H);
  const Eigen::MatrixXd full = dense(H);
  const double size = std::max(full.cwiseAbs().maxCoeff(), 1e-300);
  CHECK((full - full.transpose()).cwiseAbs().maxCoeff() < 1e-12 * size);
  Random random(37);
  for (int k = 0; k < 3; ++k) {
    const Vector p = random.values(u.size(), 1);
    Vector Hp = Vector::Zero(u.size());
    potential.hessian_product(p, Hp);
    CHECK((Hp - full * p).norm() < 1e-12 * size * p.norm() * D);
    if (project) CHECK(p.dot(Hp) > -1e-12 * size * p.squaredNorm());
  }
  std::vector<Mat<D>> blocks(static_cast<std::size_t>(grid.plan.node_count()), Mat<D>::Zero());
  potential.diagonal(blocks);
  for (int i = 0; i < grid.plan.node_count(); ++i)
    CHECK((blocks[static_cast<std::size_t>(i)] - full.template block<D, D>(i * D, i * D)).norm() < 1e-12 * size);
}

}  // namespace pf::test
