// What ties light nodes: as an energy of its own, and as a part of the consistent mass.
#include "core/energies/ghost_stiffness.hpp"

#include "core/energies/inertia.hpp"
#include "tests/energies/terms.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.1;

template <int D>
void check(const BasisInfo& basis) {
  Grid<D> grid(test::scattered<D>(40, dx, D == 2 ? 0.3 : 0.15, 71), basis.name, dx);
  GhostPenalty<D> ghost;
  ghost.build(grid.plan, grid.state.mass, 0.2);
  REQUIRE(ghost.lines() > 0);
  GhostStiffness<D> energy(ghost);
  const Vector u = test::Random(97).values(grid.unknowns(), dx);
  test::check_derivatives<D>(energy, u, 0.1 * dx);
  // Lines of four nodes are longer than the reach of a particle: the matrix has a place for all pairs of them.
  test::check_forms<D>(energy, grid, u, true);
  Vector quadratic(grid.unknowns());
  for (int i = 0; i < grid.plan.node_count(); ++i)
    for (int a = 0; a < D; ++a) {
      const Vec<D> s = grid.plan.node_position(i) / dx;
      quadratic[i * D + a] = 1 - 2 * s[a] + s[0] * s[1] - s[D - 1] * s[D - 1];
    }
  CHECK(energy.value(quadratic) < 1e-24 * energy.value(u) * quadratic.squaredNorm() / u.squaredNorm());

  const MassMatrix<D> M(grid.plan, grid.particles, grid.state.mass, {true, 0.2}, grid.parallel, grid.work);
  Inertia<D> inertia(M, Vector::Zero(grid.unknowns()), 0.02);
  test::check_forms<D>(inertia, grid, u, true);
}

}  // namespace

TEST_CASE("ghost stiffness: derivatives agree, and it is blind to quadratic displacements") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    check<2>(basis);
    check<3>(basis);
  }
}
