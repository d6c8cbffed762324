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
