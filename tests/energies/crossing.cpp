// A stressed particle that crosses a cell face: linear shape functions let its forces jump, B-splines do not (THEORY
// T6).
#include <map>

#include "tests/energies/terms.hpp"

using namespace pf;

namespace {

constexpr double dx = 0.1;

/// Nodal forces by lattice index.
template <int D>
std::map<std::array<long long, D>, Vec<D>> forces(const BasisInfo& basis, const Vec<D>& x) {
  Particles<D> one;
  test::add_particle<D>(one, x, 1, std::pow(dx / 2, D));
  one.F[0] = Mat<D>::Identity() + test::Random(3).matrix<D>(0.2);
  test::Grid<D> grid(std::move(one), basis.name, dx);
  grid.use_law(*find_law("neo_hookean"));
  ElasticEnergy<D> energy(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
  const Vector g = test::gradient_of<D>(energy, Vector::Zero(grid.unknowns()));
  std::map<std::array<long long, D>, Vec<D>> result;
  for (int i = 0; i < grid.plan.node_count(); ++i) result[grid.plan.node_index(i)] = g.segment<D>(i * D);
  return result;
}

/// Change of all nodal forces between both sides of a face, relative to their size.
template <int D>
double jump(const BasisInfo& basis, double face) {
  constexpr double h = 1e-9;
  Vec<D> left = Vec<D>::Constant(0.037), right = left;
  left[0] = face - h * dx;
  right[0] = face + h * dx;
  auto before = forces<D>(basis, left);
  const auto after = forces<D>(basis, right);
  double size = 0, change = 0;
  for (const auto& [index, f] : after) {
    size += f.norm();
    if (before.count(index) == 0) before[index] = Vec<D>::Zero();
    before[index] -= f;
  }
  for (const auto& [index, difference] : before) change += difference.norm();
  return change / size;
}

}  // namespace

TEST_CASE("crossing a cell face: a force jump with linear shape functions, none with B-splines") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    // Knots: nodes for odd degree, midpoints for even; on both sides of zero.
    for (const double cell : {-3.0, 2.0}) {
      const double face = dx * (cell + (basis.nodes_per_axis % 2 == 1 ? 0.5 : 0));
      const double in_plane = jump<2>(basis, face), in_space = jump<3>(basis, face);
      if (basis.name == "linear") {
        CHECK(in_plane > 0.1);
        CHECK(in_space > 0.1);
      } else {
        CHECK(in_plane < 1e-7);
        CHECK(in_space < 1e-7);
      }
    }
  }
}
