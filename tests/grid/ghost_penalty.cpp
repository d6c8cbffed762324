// The ghost penalty: what it must not see, what it must, and what it does to a nearly singular mass matrix.
#include "core/grid/ghost_penalty.hpp"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "tests/numerics.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.2;

/// A block of 3 cells an axis, 2 particles a cell and axis, whose outermost particles stand a hair beyond a plane of
/// nodes: the splines behind reach but a sliver of it.
template <int D>
Particles<D> sliver(double width = 1e-3) {
  Particles<D> out;
  const int n = 6, count = D == 2 ? n * n : n * n * n;
  for (int p = 0; p < count; ++p) {
    Vec<D> x;
    int rest = p;
    for (int a = 0; a < D; ++a, rest /= n) x[a] = dx / 2 * (rest % n) + width * dx;
    const double volume = std::pow(dx / 2, D);
    test::add_particle<D>(out, x, 1000 * volume, volume, 0);
  }
  return out;
}

template <int D>
Eigen::MatrixXd dense(const Grid<D>& grid, const GhostPenalty<D>& ghost) {
  const int n = grid.plan.node_count();
  Eigen::MatrixXd G(n, n);
  for (int j = 0; j < n; ++j) {
    Vector v = Vector::Zero(n * D), out = Vector::Zero(n * D);
    v[j * D] = 1;
    ghost.add_product(v, out);
    for (int i = 0; i < n; ++i) G(i, j) = out[i * D];
  }
  return G;
}

template <int D>
void check(std::string_view basis) {
  Grid<D> grid(sliver<D>(), basis, dx);
  constexpr double gamma = 0.3;
  GhostPenalty<D> ghost;
  ghost.build(grid.plan, grid.state.mass, gamma);
  REQUIRE(ghost.lines() > 0);
  const Eigen::MatrixXd G = dense(grid, ghost);
  const double size = G.cwiseAbs().maxCoeff();
  CHECK(size >= 9 * gamma * 0.1 * grid.state.mass.maxCoeff());
  CHECK((G - G.transpose()).norm() < 1e-14 * size);
  // Quadratic coefficients, and with them rigid motions, cost nothing; cubic ones do.
  Vector quadratic(grid.unknowns()), cubic(grid.unknowns()), out = Vector::Zero(grid.unknowns());
  for (int i = 0; i < grid.plan.node_count(); ++i) {
    const Vec<D> s = grid.plan.node_position(i) / dx;
    for (int a = 0; a < D; ++a) {
      quadratic[i * D + a] = 1 + a + s[0] - 2 * s[1] + 3 * s[0] * s[1] - s[D - 1] * s[D - 1] + 0.5 * s[0] * s[0];
      cubic[i * D + a] = s[0] * s[0] * s[0];
    }
  }
  ghost.add_product(quadratic, out);
  CHECK(out.norm() < 1e-12 * size * quadratic.norm());
  ghost.add_product(cubic, out);
  CHECK(cubic.dot(out) > size);
  // The diagonal is the matrix's own.
  Vector diagonal = Vector::Zero(grid.plan.node_count());
  ghost.add_diagonal(diagonal);
  CHECK((diagonal - G.diagonal()).norm() < 1e-14 * size * D);
}

/// The least eigenvalue of the consistent mass, of its largest diagonal entry.
template <int D>
double least_eigenvalue(std::string_view basis, double width, double penalty) {
  Grid<D> grid(sliver<D>(width), basis, dx);
  const MassMatrix<D> M(grid.plan, grid.particles, grid.state.mass, {true, penalty}, grid.parallel, grid.work);
  const int n = grid.plan.node_count();
  Eigen::MatrixXd full(n, n);
  for (int j = 0; j < n; ++j) {
    Vector v = Vector::Zero(n * D), Mv;
    v[j * D] = 1;
    M.multiply(v, Mv);
    for (int i = 0; i < n; ++i) full(i, j) = Mv[i * D];
  }
  CHECK((full.diagonal() - M.diagonal()).norm() < 1e-13 * full.norm());
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(full).eigenvalues()[0] / full.diagonal().maxCoeff();
}

/// How thin a sliver the outermost splines reach does not matter any more; without the penalty it is all that matters.
template <int D>
void check_slivers(std::string_view basis) {
  const double wide = least_eigenvalue<D>(basis, 1e-3, 0.3), thin = least_eigenvalue<D>(basis, 1e-5, 0.3);
  const double without = least_eigenvalue<D>(basis, 1e-3, 0);
  CAPTURE(wide);
  CAPTURE(thin);
  CAPTURE(without);
  CHECK(thin > 0.5 * wide);
  CHECK(wide > 1e4 * std::max(without, 1e-15));
}

}  // namespace

TEST_CASE("ghost penalty: blind to quadratic fields, symmetric, and cures the light nodes of the consistent mass") {
  for (const char* basis : {"quadratic", "quadratic_gimp"}) {
    CAPTURE(basis);
    check<2>(basis);
    check<3>(basis);
    check_slivers<2>(basis);
    check_slivers<3>(basis);
  }
}

TEST_CASE("ghost penalty: a body without light nodes has none, and lines that meet a corrected wall are left alone") {
  Particles<2> particles = sliver<2>();
  Grid<2> grid(particles, "quadratic", dx);
  GhostPenalty<2> ghost;
  ghost.build(grid.plan, Vector::Ones(grid.plan.node_count()), 1);
  CHECK(ghost.lines() == 0);
}
