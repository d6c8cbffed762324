// Inertia, dead loads, friction and the mouse's spring.
#include "core/energies/external.hpp"
#include "core/energies/friction.hpp"
#include "core/energies/grab.hpp"
#include "core/energies/inertia.hpp"
#include "tests/energies/terms.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.1;

template <int D>
Particles<D> cloud() {
  return test::scattered<D>(40, dx, D == 2 ? 0.3 : 0.15, 71);
}

template <int D>
void check_inertia(const BasisInfo& basis, bool consistent) {
  Grid<D> grid(cloud<D>(), basis.name, dx);
  const MassMatrix<D> M(grid.plan, grid.particles, grid.state.mass, {consistent}, grid.parallel, grid.work);
  test::Random random(73);
  const Vector v = random.values(grid.unknowns(), 1), u = random.values(grid.unknowns(), dx);
  constexpr double dt = 0.02;
  Inertia<D> energy(M, v, dt);
  test::check_derivatives<D>(energy, u, 0.1 * dx);
  test::check_forms<D>(energy, grid, u, false);
  // Zero in free flight, and there alone.
  CHECK(energy.value(dt * v) == 0);
  CHECK(test::gradient_of<D>(energy, dt * v).norm() == 0);
  Vector Mv;
  M.multiply(v, Mv);
  Vector flight;
  energy.free_flight_force(flight);
  CHECK((flight - Mv / dt).norm() < 1e-13 * Mv.norm() / dt);
}

template <int D>
void check_dead_load() {
  Grid<D> grid(cloud<D>(), "quadratic", dx);
  test::Random random(79);
  const Vector f = random.values(grid.unknowns(), 5), u = random.values(grid.unknowns(), dx);
  ExternalWork<D> energy(f);
  CHECK(energy.value(u) == -f.dot(u));
  CHECK(test::gradient_of<D>(energy, u) == -f);
  test::check_forms<D>(energy, grid, u, true);
}

/// Some nodes that rub on walls of several directions, one of them with a fixed component.
template <int D>
FeasibleSet<D> rubbing(const Grid<D>& grid) {
  FeasibleSet<D> set;
  test::Random random(83);
  for (int i = 0; i < grid.plan.node_count(); i += 3) {
    NodeConstraint<D> c;
    c.node = i;
    c.rub_normal = random.vector<D>(1).normalized();
    c.wall = random.vector<D>(dx);
    c.rub_bound = i % 2 == 0 ? random(1, 9) : 0;
    if (D == 3 && i % 6 == 0) {
      c.rub_normal = Vec<D>::UnitY();
      c.free(0, 0) = 0;
    }
    set.constrained.push_back(c);
  }
  return set;
}

template <int D>
void check_friction() {
  Grid<D> grid(cloud<D>(), "quadratic", dx);
  const FeasibleSet<D> set = rubbing(grid);
  Friction<D> energy(set);
  const Vector u = test::Random(89).values(grid.unknowns(), 3 * dx);
  test::check_derivatives<D>(energy, u, 1e-3 * dx);
  test::check_forms<D>(energy, grid, u, true);
  // The force never exceeds the bound and opposes the slip.
  const Vector g = test::gradient_of<D>(energy, u);
  for (const NodeConstraint<D>& c : set.constrained) {
    const Vec<D> f = -g.segment<D>(c.node * D), slip = rub_slip(c, Vec<D>(u.segment<D>(c.node * D)));
    CHECK(f.norm() == doctest::Approx(c.rub_bound).epsilon(1e-12));
    CHECK(f.dot(slip) == doctest::Approx(-c.rub_bound * slip.norm()).epsilon(1e-12));
  }
}

template <int D>
void check_spring(const BasisInfo& basis) {
  Grid<D> grid(cloud<D>(), basis.name, dx);
  Held held;
  for (std::uint32_t id : {3u, 8u, 21u}) {
    held.id.push_back(id);
    held.weight.push_back(held.id.size() == 1 ? 0.5 : 0.25);
  }
  const Vec<D> target = Vec<D>::Constant(0.7);
  GrabSpring<D> energy(grid.plan, grid.particles, held, target, 400);
  const Vector u = test::Random(97).values(grid.unknowns(), dx);
  test::check_derivatives<D>(energy, u, 0.1 * dx);
  // At rest it holds the weighted mean of the particles; the nodes together feel the whole force.
  Vec<D> mean = Vec<D>::Zero(), total = Vec<D>::Zero();
  for (std::size_t p = 0; p < grid.particles.size(); ++p)
    for (std::size_t k = 0; k < held.id.size(); ++k)
      if (held.id[k] == grid.particles.id[p]) mean += held.weight[k] * grid.particles.x[p];
  CHECK((energy.held_position(Vector::Zero(u.size())) - mean).norm() < 1e-14);
  const Vector g = test::gradient_of<D>(energy, u);
  for (int i = 0; i < grid.plan.node_count(); ++i) total -= g.segment<D>(i * D);
  CHECK((total - energy.force(u)).norm() < 1e-12 * total.norm());
  // diagonal() is that of the product.
  std::vector<Mat<D>> blocks(static_cast<std::size_t>(grid.plan.node_count()), Mat<D>::Zero());
  energy.diagonal(blocks);
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    Vector Hp = Vector::Zero(u.size());
    energy.hessian_product(Vector::Unit(u.size(), k), Hp);
    CHECK(Hp[k] == doctest::Approx(blocks[static_cast<std::size_t>(k / D)](k % D, k % D)).epsilon(1e-13));
  }
}

}  // namespace

TEST_CASE("inertia, lumped and consistent: derivatives, forms, free flight") {
  for (const BasisInfo& basis : bases())
    for (const bool consistent : {false, true}) {
      CAPTURE(basis.name);
      CAPTURE(consistent);
      check_inertia<2>(basis, consistent);
      check_inertia<3>(basis, consistent);
    }
}

TEST_CASE("a dead load has the potential -f.u") {
  check_dead_load<2>();
  check_dead_load<3>();
}

TEST_CASE("friction with frozen normal forces: derivatives, forms, Coulomb's bound") {
  check_friction<2>();
  check_friction<3>();
}

TEST_CASE("the mouse's spring pulls the mean of what it holds") {
  for (const BasisInfo& basis : bases()) {
    check_spring<2>(basis);
    check_spring<3>(basis);
  }
}
