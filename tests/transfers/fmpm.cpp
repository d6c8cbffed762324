// FMPM(k): the series for M^-1 that sharpens lumped velocities (Nairn and Hammerquist 2021).
#include <doctest/doctest.h>

#include "tests/numerics.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.1;

/// Three particles a cell and axis on a block: M is regular.
template <int D>
Particles<D> block() {
  Particles<D> particles;
  test::Random random(7);
  const int edge = D == 2 ? 15 : 9;
  for (int k = 0; k < (D == 2 ? edge * edge : edge * edge * edge); ++k) {
    Vec<D> x;
    for (int a = 0, rest = k; a < D; ++a, rest /= edge) x[a] = (rest % edge + 0.5) * dx / 3;
    test::add_particle<D>(particles, x, random(1, 2), 0.001);
    particles.v.back() = random.vector<D>(2);
  }
  return particles;
}

template <int D>
Vec<D> momentum_of(const Vector& mass, const Vector& v) {
  Vec<D> sum = Vec<D>::Zero();
  for (Eigen::Index i = 0; i < mass.size(); ++i) sum += mass[i] * v.segment<D>(i * D);
  return sum;
}

template <int D>
void check_sharpening(const BasisInfo& basis) {
  Grid<D> grid(block<D>(), basis.name, dx);
  lumped_velocity(grid.plan, grid.particles, grid.state);
  const MassMatrix<D> M(grid.plan, grid.particles, grid.state.mass, {true}, grid.parallel, grid.work);
  REQUIRE(M.blend() == 0);
  const Vector lumped = grid.state.v;
  Vector once = lumped;
  sharpen_velocity(M, 1, once);
  CHECK(once == lumped);
  // What is left of M v - P shrinks with every term, and no term changes the whole momentum.
  const auto left = [&](const Vector& v) {
    Vector Mv;
    M.multiply(v, Mv);
    double sum = 0;
    for (Eigen::Index i = 0; i < grid.state.mass.size(); ++i)
      sum += (Mv - grid.state.momentum).template segment<D>(i * D).squaredNorm() / grid.state.mass[i];
    return std::sqrt(sum);
  };
  double before = left(lumped);
  for (const int order : {2, 3, 4, 8, 16, 64}) {
    CAPTURE(order);
    Vector v = lumped;
    sharpen_velocity(M, order, v);
    const double now = left(v);
    CHECK(now < before);
    before = now;
    CHECK((momentum_of<D>(grid.state.mass, v) - momentum_of<D>(grid.state.mass, lumped)).norm() <
          1e-12 * grid.state.mass.sum());
  }
  CHECK(before < 0.5 * left(lumped));  // what M hardly sees comes slowly
  // Two terms by hand: v + (v - m^-1 M v).
  Vector Mv, two = lumped;
  M.multiply(lumped, Mv);
  Vector expected = 2 * lumped;
  for (Eigen::Index i = 0; i < grid.state.mass.size(); ++i)
    expected.segment<D>(i * D) -= Mv.segment<D>(i * D) / grid.state.mass[i];
  sharpen_velocity(M, 2, two);
  CHECK((two - expected).norm() < 1e-12 * expected.norm());
}

}  // namespace

TEST_CASE("FMPM of order one is the lumped transfer, and the order leads to the consistent one") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    check_sharpening<2>(basis);
    check_sharpening<3>(basis);
  }
}

namespace {

/// What the series makes of the momentum of a field that vanishes on one column of nodes and is bent elsewhere.
template <int D>
void check_held(const BasisInfo& basis) {
  Grid<D> grid(block<D>(), basis.name, dx);
  const MassMatrix<D> M(grid.plan, grid.particles, grid.state.mass, {true}, grid.parallel, grid.work);
  const double shift = 0.3;  // what is held need not be at rest
  Vector field = Vector::Zero(grid.state.mass.size() * D), momentum, lumped = field;
  std::vector<HeldNode<D>> held;
  for (int i = 0; i < grid.plan.node_count(); ++i) {
    const Vec<D> x = grid.plan.node_position(i);
    Vec<D> v = Vec<D>::Constant(0.2);
    v[0] = shift + std::max(0.0, x[0] - 2 * dx);
    if (x[0] < 2.5 * dx) held.push_back({i, Vec<D>::Ones().asDiagonal(), Vec<D>::Zero()});
    if (x[0] < 2.5 * dx) held.back().free(0, 0) = 0, held.back().value[0] = shift;
    field.template segment<D>(i * D) = v;
  }
  REQUIRE(held.size() > 0);
  REQUIRE(static_cast<int>(held.size()) < grid.plan.node_count());
  M.multiply(field, momentum);
  for (Eigen::Index i = 0; i < grid.state.mass.size(); ++i)
    lumped.template segment<D>(i * D) = momentum.template segment<D>(i * D) / grid.state.mass[i];
  // Away from the free edge, where nodes that M hardly sees come late.
  const auto error = [&](const Vector& v) {
    double sum = 0;
    for (int i = 0; i < grid.plan.node_count(); ++i)
      if (grid.plan.node_position(i)[0] < 3.5 * dx) sum += grid.state.mass[i] * std::pow(v[i * D] - field[i * D], 2);
    return std::sqrt(sum);
  };
  Vector with = lumped, without = lumped;
  sharpen_velocity(M, 4, with, held);
  sharpen_velocity(M, 4, without);
  for (const HeldNode<D>& node : held) {
    CHECK(with[node.node * D] == shift);
    CHECK(std::abs(with[node.node * D + 1] - 0.2) < 1e-12);
  }
  CHECK(error(with) < 0.5 * error(without));
}

}  // namespace

TEST_CASE("FMPM does not smooth across nodes whose velocity is held") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    check_held<2>(basis);
    check_held<3>(basis);
  }
}
