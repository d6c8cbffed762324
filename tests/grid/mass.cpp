// Lumped and consistent mass (THEORY T3), and what the consistent one does where it is singular (T6).
#include <doctest/doctest.h>

#include "tests/numerics.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.2;

/// M_ij = sum_p m_p N_i N_j written out.
template <int D>
Eigen::MatrixXd dense_mass(const Grid<D>& grid, std::string_view basis) {
  const int n = grid.plan.node_count();
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n);
  // Averaged functions have their own tests (domain.cpp): here their weights are taken as they are.
  std::vector<Vector> weights(grid.particles.size(), Vector::Zero(n));
  const bool averaged = find_basis(basis)->averaged();
  if (averaged)
    test::for_each_pair(grid.plan, [&](std::size_t p, int node, double w, const Vec<D>&) { weights[p][node] = w; });
  for (std::size_t p = 0; p < grid.particles.size(); ++p) {
    Vector& N = weights[p];
    for (int i = 0; i < n && !averaged; ++i)
      N[i] = test::shape<D>(basis, dx, grid.plan.node_position(i), grid.particles.x[p]);
    M += grid.particles.mass[p] * N * N.transpose();
  }
  return M;
}

template <int D>
void check_products(const BasisInfo& basis) {
  Grid<D> grid(test::scattered<D>(60, dx, 0.5, 23), basis.name, dx);
  Eigen::MatrixXd M = dense_mass(grid, basis.name);
  const MassMatrix<D> consistent(grid.plan, grid.particles, grid.state.mass, {true}, grid.parallel, grid.work);
  // Fewer particles than nodes make M singular, and only then it is blended with the lumped one.
  const bool few = grid.particles.size() < static_cast<std::size_t>(grid.plan.node_count());
  CHECK(consistent.blend() == (few ? singular_blend : 0));
  M = (1 - consistent.blend()) * M + consistent.blend() * Eigen::MatrixXd(grid.state.mass.asDiagonal());
  const MassMatrix<D> lumped(grid.plan, grid.particles, grid.state.mass, {false}, grid.parallel, grid.work);
  const double size = M.cwiseAbs().maxCoeff();
  CHECK((M.rowwise().sum() - grid.state.mass).norm() < 1e-13 * grid.state.mass.norm());
  CHECK((M.diagonal() - consistent.diagonal()).norm() < 1e-13 * size * D);
  test::Random random(5);
  const Vector v = random.values(grid.unknowns(), 1);
  Vector Mv, mv;
  consistent.multiply(v, Mv);
  lumped.multiply(v, mv);
  for (int a = 0; a < D; ++a) {
    Vector v_a(grid.plan.node_count()), Mv_a(v_a.size()), mv_a(v_a.size());
    for (Eigen::Index i = 0; i < v_a.size(); ++i) {
      v_a[i] = v[i * D + a];
      Mv_a[i] = Mv[i * D + a];
      mv_a[i] = mv[i * D + a];
    }
    CHECK((M * v_a - Mv_a).norm() < 1e-13 * size * v_a.norm());
    CHECK((grid.state.mass.cwiseProduct(v_a) - mv_a).norm() <= 1e-15 * size * v_a.norm());
  }
}

/// Fewer particles than nodes: of all v with M v = b the solve returns one, finite, and leaves what M does not see
/// alone.
template <int D>
void check_singular(const BasisInfo& basis, int particles) {
  Particles<D> few = test::scattered<D>(particles, dx, 0.3, 29);
  few.x[0].setConstant(-0.07);
  Grid<D> grid(few, basis.name, dx);
  const MassMatrix<D> M(grid.plan, grid.particles, grid.state.mass, {true}, grid.parallel, grid.work);
  lumped_velocity(grid.plan, grid.particles, grid.state);
  Vector v = grid.state.v;
  double residual = 1;
  M.solve(grid.state.momentum, v, residual);
  CHECK(v.allFinite());
  CHECK(residual < 1e-10);
  Vector Mv;
  M.multiply(v, Mv);
  CHECK((Mv - grid.state.momentum).norm() < 1e-9 * grid.state.momentum.norm());
}

}  // namespace

TEST_CASE("the mass matrix is the sum over particles that the theory writes") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    check_products<2>(basis);
    check_products<3>(basis);
  }
}

TEST_CASE("momenta become velocities even where the consistent mass is singular") {
  for (const BasisInfo& basis : bases())
    for (const int particles : {1, 2, 5, 40}) {
      CAPTURE(basis.name);
      CAPTURE(particles);
      check_singular<2>(basis, particles);
      check_singular<3>(basis, particles);
    }
}
