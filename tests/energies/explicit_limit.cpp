// How long an explicit step may be: against the highest frequency of the assembled grid.
#include "core/energies/explicit_limit.hpp"

#include <Eigen/Eigenvalues>

#include "core/energies/stable_step.hpp"
#include "tests/energies/terms.hpp"

using namespace pf;

namespace {

constexpr double spacing = 0.1, density = 1000;

/// Scattered particles of mass density times volume at rest.
template <int D>
Particles<D> at_rest(int count) {
  Particles<D> particles = test::scattered<D>(count, spacing, 0.25, 5);
  for (Mat<D>& F : particles.F) F.setIdentity();
  return particles;
}

/// 2 over the highest frequency of M^-1 K, M lumped.
template <int D>
double true_limit(test::Grid<D>& grid) {
  ElasticEnergy<D> elastic(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
  const Vector u = Vector::Zero(grid.unknowns());
  test::gradient_of<D>(elastic, u);
  elastic.prepare_hessian(u, false);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(u.size(), u.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    Vector column = Vector::Zero(u.size());
    elastic.hessian_product(Vector::Unit(u.size(), i), column);
    K.col(i) = column;
  }
  Vector root(u.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) root[i] = 1 / std::sqrt(std::max(grid.state.mass[i / D], 1e-300));
  // Nodes that are touched by rounding alone take no part.
  for (Eigen::Index i = 0; i < u.size(); ++i)
    if (grid.state.mass[i / D] < 1e-14 * grid.state.mass.maxCoeff()) root[i] = 0;
  const Eigen::MatrixXd scaled = root.asDiagonal() * K * root.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
  return 2 / std::sqrt(solver.eigenvalues().maxCoeff());
}

template <int D>
double limit_of(test::Grid<D>& grid) {
  return explicit_limit(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
}

template <int D>
void check_sharp(std::string_view basis, int count) {
  CAPTURE(D);
  CAPTURE(basis);
  CAPTURE(count);
  test::Grid<D> grid(at_rest<D>(count), basis, spacing);
  const double values[] = {1e5, 0.3};
  grid.laws.push_back(make_law<D>("neo_hookean", values));
  ElasticEnergy<D> elastic(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
  const double step = stable_step(elastic, grid.state.mass, FeasibleSet<D>()), right = true_limit(grid);
  CHECK(step >= right * (1 - 1e-6));  // Lanczos sees frequencies from below
  CHECK(step < 1.01 * right);
}

template <int D>
void check_bound(std::string_view basis, int count) {
  CAPTURE(D);
  CAPTURE(basis);
  test::Grid<D> grid(at_rest<D>(count), basis, spacing);
  const double values[] = {1e5, 0};  // Poisson's ratio 0: the bound is exact for a particle by itself
  grid.laws.push_back(make_law<D>("linear_elastic", values));
  const double limit = limit_of(grid), right = true_limit(grid);
  CHECK(limit <= right * (1 + 1e-9));
  CHECK(limit > 0.5 * right);
}

}  // namespace

TEST_CASE("no frequency of the grid is above the explicit limit, and it is not far below") {
  check_bound<2>("quadratic", 150);
  check_bound<2>("cubic", 150);
  check_bound<3>("quadratic", 200);
  check_bound<3>("cubic", 200);
}

TEST_CASE("at rest the explicit limit of quadratic splines is 0.816 dx/c, and it follows the stretch") {
  test::Grid<2> grid(at_rest<2>(50), "quadratic", spacing);
  const double values[] = {1e5, 0.3};
  grid.laws.push_back(make_law<2>("neo_hookean", values));
  const double at_rest = limit_of(grid);
  CHECK(at_rest == doctest::Approx(2 / std::sqrt(6.0) * spacing / grid.laws[0]->wave_speed(density)).epsilon(0x1p-24));
  const std::uint64_t visits = grid.work.tangent;
  CHECK(visits == grid.particles.size());
  // Stretched threefold along x: dP/dF of a wave along x is mu (1 + s^-2) + lambda (1 - ln s) s^-2, pushed forward by
  // s.
  const double s = 3, nu = 0.3, mu = 1e5 / 2 / (1 + nu), lambda = 1e5 * nu / (1 + nu) / (1 - 2 * nu);
  for (Mat<2>& F : grid.particles.F) F << s, 0, 0, 1;
  const double along = mu * (s * s + 1) + lambda * (1 - std::log(s));
  CHECK(limit_of(grid) == doctest::Approx(2 / std::sqrt(6.0) * spacing / std::sqrt(along / density)).epsilon(0x1p-24));
  CHECK(limit_of(grid) < 0.6 * at_rest);
}

TEST_CASE("the stable step is 2 over the grid's highest frequency, to a per cent") {
  for (const BasisInfo& basis : bases())
    for (const int count : {1, 7, 60}) {
      check_sharp<2>(basis.name, count);
      check_sharp<3>(basis.name, count);
    }
}

TEST_CASE("nodes that are held take no part in the stable step; where all are, there is none") {
  test::Grid<2> grid(at_rest<2>(40), "quadratic", spacing);
  const double values[] = {1e5, 0.3};
  grid.laws.push_back(make_law<2>("neo_hookean", values));
  ElasticEnergy<2> elastic(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
  FeasibleSet<2> set;
  const double all_free = stable_step(elastic, grid.state.mass, set);
  for (int i = 0; i < grid.plan.node_count(); ++i) {
    NodeConstraint<2> held{};
    held.node = i;
    held.free(0, 0) = 1;  // along x alone
    held.free(0, 1) = held.free(1, 0) = held.free(1, 1) = 0;
    set.constrained.push_back(held);
  }
  CHECK(stable_step(elastic, grid.state.mass, set) > all_free);
  for (NodeConstraint<2>& c : set.constrained) c.free.setZero();
  CHECK(std::isinf(stable_step(elastic, grid.state.mass, set)));
}
