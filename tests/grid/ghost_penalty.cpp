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
Particles<D> sliver() {
  Particles<D> out;
  const int n = 6, count = D == 2 ? n * n : n * n * n;
  out.resize(static_cast<std::size_t>(count));
  for (int p = 0; p < count; ++p) {
    const auto k = static_cast<std::size_t>(p);
    int rest = p;
    for (int a = 0; a < D; ++a, rest /= n) out.x[k][a] = dx / 2 * (rest % n) + 1e-3 * dx;
    out.X[k] = out.x[k];
    out.mass[k] = out.volume0[k] = std::pow(dx / 2, D);
    out.F[k].setIdentity();
    out.id[k] = static_cast<std::uint32_t>(p);
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
  // Against the lumped matrix, the consistent one with it is far from singular.
  const auto least = [&](double penalty) {
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
  };
  const double without = least(0), with = least(gamma);
  CAPTURE(without);
  CHECK(with > 1e-3);
  CHECK(with > 100 * without);
}

}  // namespace

TEST_CASE("ghost penalty: blind to quadratic fields, symmetric, and cures the light nodes of the consistent mass") {
  for (const char* basis : {"quadratic", "quadratic_gimp"}) {
    CAPTURE(basis);
    check<2>(basis);
    check<3>(basis);
  }
}

TEST_CASE("ghost penalty: a body without light nodes has none, and lines that meet a corrected wall are left alone") {
  Particles<2> particles = sliver<2>();
  Grid<2> grid(particles, "quadratic", dx);
  GhostPenalty<2> ghost;
  ghost.build(grid.plan, Vector::Ones(grid.plan.node_count()), 1);
  CHECK(ghost.lines() == 0);
}
