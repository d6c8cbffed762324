// The plan of a step: nodes, weights and order of particles in unfriendly places.
#include <doctest/doctest.h>

#include <limits>
#include <set>

#include "core/grid/stencil.hpp"
#include "tests/numerics.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.1;

template <int D>
void check_pairs(const BasisInfo& basis) {
  Grid<D> grid(test::scattered<D>(300, dx, 1.3, 7, 3), basis.name, dx);
  REQUIRE(grid.planned);
  std::vector<double> sum(grid.particles.size(), 0);
  std::vector<Vec<D>> position(grid.particles.size(), Vec<D>::Zero());
  std::vector<Mat<D>> stretch(grid.particles.size(), Mat<D>::Zero());
  std::vector<bool> used(static_cast<std::size_t>(grid.plan.node_count()), false);
  double worst = 0;
  test::for_each_pair(grid.plan, [&](std::size_t p, int node, double N, const Vec<D>& grad) {
    REQUIRE(node >= 0);
    REQUIRE(node < grid.plan.node_count());
    used[static_cast<std::size_t>(node)] = true;
    const Vec<D> x_i = grid.plan.node_position(node);
    if (!basis.averaged())
      worst = std::max(worst, std::abs(N - test::shape<D>(basis.name, dx, x_i, grid.particles.x[p])));
    sum[p] += N;
    position[p] += N * x_i;
    stretch[p] += x_i * grad.transpose();
  });
  CHECK(worst < 1e-13);
  for (std::size_t p = 0; p < sum.size(); ++p) {
    CHECK(std::abs(sum[p] - 1) < 1e-14);
    CHECK((position[p] - grid.particles.x[p]).norm() < 1e-14);
    CHECK((stretch[p] - Mat<D>::Identity()).norm() < 1e-12);
  }
  for (const bool u : used) CHECK(u);
}

template <int D>
void check_look_up(const BasisInfo& basis) {
  Grid<D> grid(test::scattered<D>(200, dx, 0.9, 3), basis.name, dx);
  std::set<std::array<long long, D>> seen;
  for (int i = 0; i < grid.plan.node_count(); ++i) {
    CHECK(grid.plan.find_node(grid.plan.node_index(i)) == i);
    seen.insert(grid.plan.node_index(i));
  }
  CHECK(static_cast<int>(seen.size()) == grid.plan.node_count());
  int absent = 0;
  for (long long x = -20; x <= 20; ++x)
    for (long long y = -20; y <= 20; ++y) {
      std::array<long long, D> index{};
      index[0] = x;
      index[1] = y;
      const int found = grid.plan.find_node(index);
      CHECK((found >= 0) == (seen.count(index) == 1));
      absent += found < 0;
    }
  CHECK(absent > 0);
}

template <int D>
void check_mass_and_ids(const BasisInfo& basis) {
  const Particles<D> before = test::scattered<D>(400, dx, 1.1, 11, 4);
  double total = 0;
  for (const double m : before.mass) total += m;
  Grid<D> grid(before, basis.name, dx);
  CHECK(std::abs(grid.state.mass.sum() - total) < 1e-13 * total);
  CHECK(grid.state.mass.minCoeff() >= 0);
  std::set<std::uint32_t> ids;
  bool moved = false;
  for (std::size_t p = 0; p < grid.particles.size(); ++p) {
    const std::uint32_t id = grid.particles.id[p];
    ids.insert(id);
    moved = moved || id != p;
    CHECK(grid.particles.x[p] == before.x[id]);
    CHECK(grid.particles.v[p] == before.v[id]);
    CHECK(grid.particles.F[p] == before.F[id]);
    CHECK(grid.particles.C[p] == before.C[id]);
    CHECK(grid.particles.mass[p] == before.mass[id]);
    CHECK(grid.particles.volume0[p] == before.volume0[id]);
    CHECK(grid.particles.material[p] == before.material[id]);
  }
  CHECK(ids.size() == before.size());
  CHECK(moved);
  for (const MaterialRun& run : grid.plan.runs())
    for (std::int32_t p = run.begin; p < run.end; ++p)
      CHECK(grid.particles.material[static_cast<std::size_t>(p)] == run.material);
}

template <int D>
void check_colours(const BasisInfo& basis) {
  Grid<D> grid(test::scattered<D>(300, dx, 2.5, 5), basis.name, dx);
  const int edge = block_edge + grid.plan.nodes_per_axis() - 1;
  std::size_t listed = 0;
  for (const std::vector<int>& colour : grid.plan.colours()) {
    std::set<std::int32_t> nodes;
    listed += colour.size();
    for (const int b : colour) {
      const std::int32_t* table = grid.plan.node_table(grid.plan.blocks()[static_cast<std::size_t>(b)]);
      for (int i = 0; i < (D == 2 ? edge * edge : edge * edge * edge); ++i)
        if (table[i] >= 0) CHECK(nodes.insert(table[i]).second);
    }
  }
  CHECK(listed == grid.plan.blocks().size());
}

template <int D>
void check_threads(const BasisInfo& basis) {
  const Particles<D> start = test::scattered<D>(500, dx, 1.7, 13, 2);
  Grid<D> one(start, basis.name, dx, 1), three(start, basis.name, dx, 3);
  CHECK(one.particles.id == three.particles.id);
  REQUIRE(one.plan.node_count() == three.plan.node_count());
  for (int i = 0; i < one.plan.node_count(); ++i) CHECK(one.plan.node_index(i) == three.plan.node_index(i));
  CHECK(one.state.mass == three.state.mass);
  CHECK(one.state.momentum == three.state.momentum);
}

template <int D>
void check_refusals(const BasisInfo& basis) {
  Grid<D> grid(test::scattered<D>(20, dx, 1, 17), basis.name, dx);
  Scratch memory;
  Motion<D> moved = apart<D>(grid.particles.size(), false, memory);
  CHECK(grid.plan.foresee(grid.particles, Vector::Zero(grid.unknowns()), moved, grid.parallel));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300, -1e300}) {
    Particles<D> particles = grid.particles;
    particles.x[7][D - 1] = bad;
    CHECK_FALSE(grid.plan.foresee(grid.particles, Vector::Constant(grid.unknowns(), bad), moved, grid.parallel));
    Plan<D> plan;
    CHECK_FALSE(plan.build(particles, basis, dx, grid.parallel));
  }
}

/// Steps of `way` cells: what follow() makes of particles is what build() makes of them where they have come to.
template <int D>
void check_following(const BasisInfo& basis, double way, bool exchange, int threads) {
  Grid<D> grid(test::scattered<D>(700, dx, 1.7, 41, 2), basis.name, dx, threads);
  for (std::size_t p = 0; p < grid.particles.size(); ++p) grid.particles.X[p] = grid.particles.x[p] * 2;
  Particles<D> other;
  Scratch memory;
  for (int step = 0; step < 5; ++step) {
    const Particles<D> before = grid.particles;
    test::Random random(static_cast<unsigned>(step) + 3);
    const Vector u = Vector::Constant(grid.unknowns(), way * dx) + random.values(grid.unknowns(), way * dx);
    Motion<D> moved = exchange ? exchanged<D>(before, true, other) : apart<D>(before.size(), true, memory);
    REQUIRE(grid.plan.foresee(grid.particles, u, moved, grid.parallel));
    Particles<D> expected = before;
    for (std::size_t p = 0; p < before.size(); ++p) {
      const std::size_t to = moved.place ? moved.place[p] : p;
      expected.x[p] = moved.x[p];
      moved.v[to] = expected.v[p] = before.v[p] + before.x[p];
      moved.F[to] = expected.F[p] = before.F[p] * 1.5;
      moved.C[to] = expected.C[p] = before.C[p] * 2;
    }
    CHECK(grid.particles.x == before.x);
    grid.plan.follow(grid.particles, moved, grid.parallel);
    Plan<D> plan;
    Parallel one(1);
    REQUIRE(plan.build(expected, basis, dx, one));
    CHECK(grid.particles.id == expected.id);
    CHECK(grid.particles.X == expected.X);
    CHECK(grid.particles.x == expected.x);
    CHECK(grid.particles.v == expected.v);
    CHECK(grid.particles.F == expected.F);
    CHECK(grid.particles.C == expected.C);
    CHECK(grid.particles.mass == expected.mass);
    CHECK(grid.particles.volume0 == expected.volume0);
    CHECK(grid.particles.body == expected.body);
    CHECK(grid.particles.material == expected.material);
    CHECK(grid.plan.node_indices() == plan.node_indices());
    CHECK(grid.plan.batches().size() == plan.batches().size());
  }
}

}  // namespace

TEST_CASE("particles that move come into the order that a new plan would give them") {
  for (const BasisInfo& basis : bases())
    for (const double way : {0.0, 1e-3, 0.05, 0.7, 9.0})  // nobody, few, many leave their cells; all leave the region
      for (const bool exchange : {false, true}) {
        CAPTURE(basis.name);
        CAPTURE(way);
        CAPTURE(exchange);
        check_following<2>(basis, way, exchange, 1);
        check_following<3>(basis, way, exchange, 3);
      }
}

TEST_CASE("a plan couples every particle to the nodes of its support with the weights of the theory") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    check_pairs<2>(basis);
    check_pairs<3>(basis);
  }
}

TEST_CASE("find_node finds the active nodes and no others") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    check_look_up<2>(basis);
    check_look_up<3>(basis);
  }
}

TEST_CASE("sorting loses no particle and the grid holds their mass to rounding") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    check_mass_and_ids<2>(basis);
    check_mass_and_ids<3>(basis);
  }
}

TEST_CASE("blocks of one colour share no node") {
  for (const BasisInfo& basis : bases()) {
    check_colours<2>(basis);
    check_colours<3>(basis);
  }
}

TEST_CASE("a plan and its sums do not depend on the number of threads") {
  for (const BasisInfo& basis : bases()) {
    check_threads<2>(basis);
    check_threads<3>(basis);
  }
}

TEST_CASE("positions that no grid can hold are refused, not indexed") {
  for (const BasisInfo& basis : bases()) {
    check_refusals<2>(basis);
    check_refusals<3>(basis);
  }
}
