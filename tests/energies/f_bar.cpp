// F-bar: particles of a cell share their change of volume, and the energy stays an energy.
#include "core/energies/volume_patches.hpp"
#include "tests/energies/terms.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.1;

template <int D>
struct Shared : Grid<D> {
  Shared(Particles<D> of, const LawInfo& law, std::string_view basis, int threads = 1)
      : Grid<D>(std::move(of), basis, dx, threads) {
    this->use_law(law);
    this->laws.back()->share_volume(true);
  }
  ElasticEnergy<D> energy() { return {this->plan, this->particles, this->laws, this->parallel, this->work}; }
};

template <int D>
Vector strained(const Grid<D>& grid, unsigned seed) {
  return test::Random(seed).values(grid.unknowns(), 0.05 * dx);
}

template <int D>
Vector affine(const Grid<D>& grid, const Mat<D>& A) {
  Vector u(grid.unknowns());
  for (int i = 0; i < grid.plan.node_count(); ++i)
    u.segment<D>(i * D) = (A - Mat<D>::Identity()) * grid.plan.node_position(i);
  return u;
}

}  // namespace

TEST_CASE("F-bar: gradient and Hessian are derivatives of the value") {
  test::for_all([](auto d, const LawInfo& law, const BasisInfo& basis) {
    constexpr int D = d;
    Shared<D> grid(test::scattered<D>(40, dx, 0.25, 41), law, basis.name);
    ElasticEnergy<D> energy = grid.energy();
    test::check_derivatives<D>(energy, strained(grid, 2), 1e-3 * dx, test::stored_tangents);
  });
}

TEST_CASE("F-bar: product, assembled matrix and diagonal are one Hessian, projected or not") {
  test::for_all([](auto d, const LawInfo& law, const BasisInfo& basis) {
    constexpr int D = d;
    Shared<D> grid(test::scattered<D>(30, dx, D == 2 ? 0.25 : 0.15, 43), law, basis.name);
    ElasticEnergy<D> energy = grid.energy();
    const Vector u = strained(grid, 3);
    test::check_forms<D>(energy, grid, u, false);
    test::check_forms<D>(energy, grid, u, true);
  });
}

TEST_CASE("F-bar: beside materials without it the energy is the sum of both, and its derivatives are its own") {
  Grid<2> grid(test::scattered<2>(200, dx, 0.5, 47, 3), "quadratic", dx);
  for (const char* name : {"neo_hookean", "hencky", "fixed_corotated"}) grid.use_law(*find_law(name));
  grid.laws[1]->share_volume(true);
  ElasticEnergy<2> energy(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
  const Vector u = strained(grid, 5);
  const std::vector<Mat<2>> F = energy.deformed(u);
  double sum = 0;
  for (std::size_t p = 0; p < grid.particles.size(); ++p)
    sum += grid.particles.volume0[p] * test::energy<2>(*grid.laws[grid.particles.material[p]], F[p]);
  CHECK(energy.value(u) == doctest::Approx(sum).epsilon(1e-13));
  test::check_derivatives<2>(energy, u, 1e-3 * dx, test::stored_tangents);
  grid.laws[1]->share_volume(false);
  ElasticEnergy<2> without(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work);
  const std::vector<Mat<2>> own = without.deformed(u);
  double most = 0;
  for (std::size_t p = 0; p < F.size(); ++p) {
    if (grid.particles.material[p] == 1)
      most = std::max(most, (F[p] - own[p]).norm());
    else
      CHECK((F[p] - own[p]).norm() < 1e-14);
  }
  CHECK(most > 1e-3);
}

TEST_CASE("F-bar: an affine motion is untouched: F, energy and forces are those without it") {
  test::for_all([](auto d, const LawInfo& law, const BasisInfo& basis) {
    constexpr int D = d;
    Particles<D> particles = test::scattered<D>(200, dx, 0.7, 53);
    for (Mat<D>& F : particles.F) F = particles.F.front();
    Shared<D> grid(std::move(particles), law, basis.name);
    const Vector u = affine<D>(grid, Mat<D>::Identity() + test::Random(7).matrix<D>(0.3));
    ElasticEnergy<D> shared = grid.energy();
    const std::vector<Mat<D>> F = shared.deformed(u);
    const Vector g = test::gradient_of<D>(shared, u);
    const double E = shared.value(u);
    grid.laws[0]->share_volume(false);
    ElasticEnergy<D> own = grid.energy();
    const std::vector<Mat<D>> expected = own.deformed(u);
    double worst = 0;
    for (std::size_t p = 0; p < F.size(); ++p) worst = std::max(worst, (F[p] - expected[p]).norm());
    CHECK(worst < 1e-13);
    CHECK(E == doctest::Approx(own.value(u)).epsilon(1e-12));
    const Vector g_own = test::gradient_of<D>(own, u);
    CHECK((g - g_own).norm() < 1e-11 * g_own.template lpNorm<1>());
  });
}

TEST_CASE("F-bar: a patch keeps its volume, and its particles change theirs alike") {
  Shared<3> grid(test::scattered<3>(300, dx, 0.4, 57), *find_law("neo_hookean"), "quadratic");
  ElasticEnergy<3> energy = grid.energy();
  const Vector u = strained(grid, 9);
  const std::vector<Mat<3>> shared = energy.deformed(u);
  grid.laws[0]->share_volume(false);
  const std::vector<Mat<3>> own = grid.energy().deformed(u);
  grid.laws[0]->share_volume(true);
  int patches = 0;
  for (const Block<3>& block : grid.plan.blocks())
    for_each_patch(grid.plan, grid.particles, grid.laws, block, [&](const VolumePatch& patch) {
      ++patches;
      double volume = 0, shared_volume = 0;
      const auto change = [&](std::int32_t p) {
        const auto k = static_cast<std::size_t>(p);
        return shared[k].determinant() / grid.particles.F[k].determinant();
      };
      for (std::int32_t p = patch.begin; p < patch.end; ++p) {
        const auto k = static_cast<std::size_t>(p);
        volume += grid.particles.volume0[k] * own[k].determinant();
        shared_volume += grid.particles.volume0[k] * shared[k].determinant();
        CHECK(change(p) == doctest::Approx(change(patch.begin)).epsilon(1e-12));
      }
      CHECK(shared_volume == doctest::Approx(volume).epsilon(1e-12));
    });
  CHECK(patches > 20);
}

TEST_CASE("F-bar: forces at rest are the gradient at u = 0, sum to nothing and turn nothing") {
  test::for_all([](auto d, const LawInfo& law, const BasisInfo& basis) {
    constexpr int D = d;
    Shared<D> grid(test::scattered<D>(100, dx, 0.4, 59), law, basis.name);
    ElasticEnergy<D> energy = grid.energy();
    const Vector rest = Vector::Zero(grid.unknowns()), g = test::gradient_of<D>(energy, rest);
    Vector at_rest = rest;
    energy.add_force_at_rest(at_rest);
    CHECK((at_rest - g).norm() < 1e-13 * g.norm());
    CHECK(energy.find_rest() == doctest::Approx(energy.value(rest)).epsilon(1e-13));
    const Vector u = strained(grid, 11), moved = test::gradient_of<D>(energy, u);
    test::check_balance(grid.plan, u, moved, law.objective);
  });
}

TEST_CASE("F-bar: no energy where a particle of a patch would be turned inside out, whatever the law") {
  for (const LawInfo& law : laws()) {
    CAPTURE(law.name);
    Shared<2> grid(test::scattered<2>(60, dx, 0.25, 61), law, "quadratic");
    Mat<2> mirror = Mat<2>::Identity();
    mirror(0, 0) = -0.5;
    CHECK(grid.energy().value(affine<2>(grid, mirror)) == std::numeric_limits<double>::infinity());
  }
}

TEST_CASE("F-bar: value, force and product are the same bits for any number of threads") {
  const auto with = [](int threads, Vector& g, Vector& Hp) {
    Shared<3> grid(test::scattered<3>(2000, dx, 1.1, 67), *find_law("neo_hookean"), "quadratic", threads);
    ElasticEnergy<3> energy = grid.energy();
    const Vector u = strained(grid, 13);
    g = test::gradient_of<3>(energy, u);
    energy.prepare_hessian(u, false);
    Hp = Vector::Zero(u.size());
    energy.hessian_product(g, Hp);
    return energy.value(u);
  };
  Vector g, Hp, g_two, Hp_two;
  const double E = with(1, g, Hp), E_two = with(3, g_two, Hp_two);
  CHECK(E == E_two);
  CHECK(g == g_two);
  CHECK(Hp == Hp_two);
}
