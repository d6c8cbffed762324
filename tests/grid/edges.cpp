// Splines that end at walls (core/grid/edges.hpp): the node on the wall has the motion there.
#include <doctest/doctest.h>

#include <map>

#include "tests/numerics.hpp"

using namespace pf;

namespace {

constexpr double dx = 0.1;

template <int D>
Particles<D> near_walls(double low, double high) {
  test::Random random(5);
  Particles<D> particles;
  for (int p = 0; p < 60; ++p) {
    Vec<D> x = random.vector<D>(0.2);
    x[0] = random(low, high);
    if (p == 0) x[0] = low;
    if (p == 1) x[0] = high;
    test::add_particle<D>(particles, x, 1, std::pow(dx / 2, D));
  }
  return particles;
}

template <int D>
void check_edges(const BasisInfo& basis) {
  const bool opens = basis.bends;
  Parallel parallel(2);
  // Averaged particles keep half their domain off the wall.
  const double off = basis.averaged() ? dx / 4 : 0;
  Particles<D> particles = near_walls<D>(off, 0.6 - off);
  Plan<D> plan;
  std::array<EdgePlanes, D> edges;
  edges[0] = {0, 6};
  plan.set_edges(edges);
  REQUIRE(plan.build(particles, basis, dx, parallel));
  CHECK_FALSE(plan.edges_left());
  std::vector<double> sum(particles.size(), 0);
  std::vector<Vec<D>> place(sum.size(), Vec<D>::Zero());
  std::vector<Mat<D>> stretch(sum.size(), Mat<D>::Zero());
  std::vector<double> at_wall(sum.size(), 0);
  double behind = 0;
  test::for_each_pair(plan, [&](std::size_t p, int node, double N, const Vec<D>& grad) {
    const Vec<D> x_i = plan.node_position(node);
    const long long i = plan.node_index(node)[0];
    if (opens && (i < 0 || i > 6)) behind = std::max({behind, std::abs(N), grad.norm() * dx});
    CHECK(N > -1e-15);
    sum[p] += N;
    place[p] += N * x_i;
    stretch[p] += x_i * grad.transpose();
    if (i == 0) at_wall[p] += N;
  });
  CHECK(behind == 0);
  for (std::size_t p = 0; p < sum.size(); ++p) {
    CHECK(std::abs(sum[p] - 1) < 1e-14);
    CHECK((place[p] - particles.x[p]).norm() < 1e-14);
    CHECK((stretch[p] - Mat<D>::Identity()).norm() < 1e-12);
    // At the wall nothing but the function that is held counts.
    if (off == 0 && particles.id[p] == 0) CHECK(at_wall[p] == doctest::Approx(1).epsilon(1e-14));
  }
  // Particles far behind a wall: as without, and told.
  for (Vec<D>& x : particles.x) x[0] -= 0.51 * dx + off;
  REQUIRE(plan.build(particles, basis, dx, parallel));
  CHECK(plan.edges_left() == opens);
  if (opens) CHECK(plan.regular() == !basis.averaged());
}

}  // namespace

TEST_CASE("splines that end at a wall keep linear fields, sums and signs, and interpolate there") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    check_edges<2>(basis);
    check_edges<3>(basis);
  }
}
