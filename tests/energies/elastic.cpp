// The elastic energy on the grid, for every law and basis.
#include <Eigen/Geometry>

#include "tests/energies/terms.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.1;

/// Displacements that leave every J_p > 0 and strain the particles by some tenths.
template <int D>
Vector strained(const Grid<D>& grid, unsigned seed) {
  return test::Random(seed).values(grid.unknowns(), 0.05 * dx);
}

/// u_i = (A - I) x_i + b.
template <int D>
Vector affine(const Grid<D>& grid, const Mat<D>& A, const Vec<D>& b) {
  Vector u(grid.unknowns());
  for (int i = 0; i < grid.plan.node_count(); ++i)
    u.segment<D>(i * D) = (A - Mat<D>::Identity()) * grid.plan.node_position(i) + b;
  return u;
}

template <int D>
Grid<D>& with_law(Grid<D>& grid, const LawInfo& law) {
  grid.use_law(law);
  return grid;
}

}  // namespace

TEST_CASE("elastic energy: gradient and Hessian are derivatives of the value") {
  test::for_all([](auto d, const LawInfo& law, const BasisInfo& basis) {
    constexpr int D = d;
    Grid<D> grid(test::scattered<D>(40, dx, 0.25, 41), basis.name, dx);
    with_law(grid, law);
    ElasticEnergy<D> energy(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
    test::check_derivatives<D>(energy, strained(grid, 2), 1e-3 * dx, test::stored_tangents);
  });
}

TEST_CASE("elastic energy: product, assembled matrix and diagonal are one Hessian, projected or not") {
  test::for_all([](auto d, const LawInfo& law, const BasisInfo& basis) {
    constexpr int D = d;
    Grid<D> grid(test::scattered<D>(30, dx, D == 2 ? 0.25 : 0.15, 43), basis.name, dx);
    with_law(grid, law);
    ElasticEnergy<D> energy(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
    const Vector u = strained(grid, 3);
    test::check_forms<D>(energy, grid, u, false);
    test::check_forms<D>(energy, grid, u, true);
  });
}

TEST_CASE("elastic energy: only what meets a marked node is projected") {
  int indefinite = 0;
  test::for_all([&](auto d, const LawInfo& law, const BasisInfo& basis) {
    constexpr int D = d;
    Grid<D> grid(test::scattered<D>(60, dx, D == 2 ? 0.8 : 0.6, 43), basis.name, dx);
    with_law(grid, law);
    for (Mat<D>& F : grid.particles.F) F *= 0.7;
    ElasticEnergy<D> energy(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
    const Vector u = strained(grid, 3);
    const auto hessian = [&](const Projected& project) {
      const FeasibleSet<D> free;
      IncrementalPotential<D> potential(grid.plan, grid.state.mass, free, {&energy}, {});
      potential.prepare_hessian(u, project);
      BlockMatrix<D> H;
      potential.assemble(H);
      return test::dense(H);
    };
    const Eigen::MatrixXd plain = hessian(false), all = hessian(true);
    const int count = grid.plan.node_count();
    Eigen::Index row = 0, column = 0;
    (all - plain).cwiseAbs().maxCoeff(&row, &column);
    const int marked = static_cast<int>(row) / D;
    std::vector<char> marks(static_cast<std::size_t>(count), 0);
    marks[static_cast<std::size_t>(marked)] = 1;
    const Eigen::MatrixXd some = hessian(Projected(marks));
    CHECK(some.middleRows<D>(marked * D) == all.middleRows<D>(marked * D));
    indefinite += (all - plain).row(row).norm() > 1e-3 * plain.row(row).norm();
    int far = 0;
    for (int i = 0; i < count; ++i) {
      long long apart = 0;
      for (std::size_t a = 0; a < D; ++a)
        apart = std::max(apart, std::abs(grid.plan.node_index(i)[a] - grid.plan.node_index(marked)[a]));
      if (apart < grid.plan.nodes_per_axis()) continue;
      ++far;
      CHECK(some.middleRows<D>(i * D) == plain.middleRows<D>(i * D));
    }
    CHECK(far > 0);
  });
  CHECK(indefinite > 10);
}

TEST_CASE("elastic energy: a body of several materials is the sum of its parts") {
  const std::span<const LawInfo> all = laws();
  const int count = static_cast<int>(all.size());
  Grid<2> grid(test::scattered<2>(300, dx, 0.6, 47, count), "quadratic", dx);
  for (const LawInfo& law : all) grid.use_law(law);
  ElasticEnergy<2> energy(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
  const Vector u = strained(grid, 5);
  const double E = energy.value(u);
  const std::vector<Mat<2>> F = energy.deformed(u);
  double sum = 0;
  for (std::size_t p = 0; p < grid.particles.size(); ++p)
    sum += grid.particles.volume0[p] * test::energy<2>(*grid.laws[grid.particles.material[p]], F[p]);
  CHECK(E == doctest::Approx(sum).epsilon(1e-13));
  test::check_derivatives<2>(energy, u, 1e-3 * dx, test::stored_tangents);
}

TEST_CASE("patch test: an affine motion of the nodes gives every particle the exact F") {
  test::for_all([](auto d, const LawInfo& law, const BasisInfo& basis) {
    constexpr int D = d;
    Grid<D> grid(test::scattered<D>(200, dx, 0.7, 53), basis.name, dx);
    with_law(grid, law);
    ElasticEnergy<D> energy(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
    const Mat<D> A = Mat<D>::Identity() + test::Random(7).matrix<D>(0.3);
    const std::vector<Mat<D>> F = energy.deformed(affine<D>(grid, A, Vec<D>::Constant(0.4)));
    double worst = 0;
    for (std::size_t p = 0; p < grid.particles.size(); ++p)
      worst = std::max(worst, (F[p] - A * grid.particles.F[p]).norm());
    CHECK(worst < 1e-13);
  });
}

TEST_CASE("the energy's gradient sums to no force, and for objective laws to no torque") {
  test::for_all([](auto d, const LawInfo& law, const BasisInfo& basis) {
    constexpr int D = d;
    Grid<D> grid(test::scattered<D>(100, dx, 0.4, 59), basis.name, dx);
    with_law(grid, law);
    ElasticEnergy<D> energy(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
    const Vector u = strained(grid, 11), g = test::gradient_of<D>(energy, u);
    test::check_balance(grid.plan, u, g, law.objective);
  });
}

TEST_CASE("a rigid rotation stores no energy under an objective law, and some under linear elasticity") {
  test::for_all([](auto d, const LawInfo& law, const BasisInfo& basis) {
    constexpr int D = d;
    Particles<D> particles = test::scattered<D>(100, dx, 0.4, 61);
    for (Mat<D>& F : particles.F) F.setIdentity();
    Grid<D> grid(std::move(particles), basis.name, dx);
    with_law(grid, law);
    ElasticEnergy<D> energy(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
    const double turned = energy.value(affine<D>(grid, test::rotation<D>(0.8), Vec<D>::Constant(-0.1)));
    const double stretched = energy.value(affine<D>(grid, 1.1 * Mat<D>::Identity(), Vec<D>::Zero()));
    CHECK(stretched > 0);
    CHECK((std::abs(turned) < 1e-12 * stretched) == law.objective);
  });
}

TEST_CASE("the sizes that Newton's tolerance is measured with are s_i of the theory") {
  const LawInfo& law = *find_law("neo_hookean");
  for (const BasisInfo& basis : bases()) {
    Grid<2> grid(test::scattered<2>(50, dx, 0.3, 67), basis.name, dx);
    grid.use_law(law);
    ElasticEnergy<2> energy(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
    const Vector u = strained(grid, 13);
    Vector g = Vector::Zero(u.size()), magnitude = Vector::Zero(grid.plan.node_count());
    energy.gradient(u, g, magnitude);
    Vector expected = Vector::Zero(grid.plan.node_count());
    const std::vector<Mat<2>> F = energy.deformed(u);
    test::for_each_pair(grid.plan, [&](std::size_t p, int node, double, const Vec<2>& grad) {
      const Mat<2> T =
          grid.particles.volume0[p] * test::evaluate<2>(*grid.laws[0], F[p]).P * grid.particles.F[p].transpose();
      expected[node] += (T * grad).norm();
    });
    CHECK((magnitude - expected).norm() < 0x1p-23 * expected.norm());  // roots are taken in single precision
  }
}
