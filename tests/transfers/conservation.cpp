// What particle-grid transfers keep (THEORY T5, T6).
#include <doctest/doctest.h>

#include <map>

#include "core/step/balance.hpp"
#include "tests/numerics.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.1;

/// Particles in general position: at a face the linear basis has nodes without mass but with a gradient.
template <int D>
Particles<D> general(int count, unsigned seed) {
  Particles<D> particles = test::scattered<D>(count, dx, 0.35, seed);
  test::Random random(seed + 1);
  for (Vec<D>& x : particles.x) x = random.vector<D>(0.35);
  return particles;
}

/// Two particles a cell and axis, each moved by up to a quarter of their distance, with random velocities.
Particles<2> jittered(int edge) {
  Particles<2> particles;
  test::Random random(139);
  for (int i = 0; i < edge; ++i)
    for (int j = 0; j < edge; ++j) {
      test::add_particle<2>(particles,
                            Vec<2>((i + 0.5 + random(-0.25, 0.25)) * dx / 2, (j + 0.5 + random(-0.25, 0.25)) * dx / 2),
                            1, 0.001);
      particles.v.back() = random.vector<2>(2);
    }
  return particles;
}

template <class F>
void for_all(F&& f) {
  for (const BasisInfo& basis : bases())
    for (const TransferInfo& transfer : transfers()) {
      CAPTURE(basis.name);
      CAPTURE(transfer.name);
      f(std::integral_constant<int, 2>{}, basis, transfer);
      f(std::integral_constant<int, 3>{}, basis, transfer);
    }
}

/// Particles to grid and back, with nothing happening on the grid.
template <int D>
struct RoundTrip {
  RoundTrip(Particles<D> particles, const BasisInfo& basis, std::string_view name, double flip_ratio = 0.95)
      : grid(std::move(particles), basis.name, dx), transfer(make_transfer<D>(name, flip_ratio)) {
    if (!transfer->affine())
      for (Mat<D>& C : grid.particles.C) C.setZero();
    particles_to_grid(grid.plan, grid.particles, transfer->affine(), grid.parallel, grid.state);
    lumped_velocity(grid.plan, grid.particles, grid.state);
    const MassMatrix<D> M(grid.plan, grid.particles, grid.state.mass, {true}, grid.parallel, grid.work);
    sharpen_velocity(M, transfer->order(), grid.state.v);
    grid.state.v_end = grid.state.v;
    before = balance();
    start = grid.particles;
    transfer->grid_to_particles(grid.plan, grid.state, grid.particles, grid.parallel,
                                {nullptr, grid.particles.v.data(), nullptr, grid.particles.C.data()});
    after = balance();
  }
  Balance balance() {
    Laws<D> laws;
    laws.push_back(make_law<D>("neo_hookean", test::typical_parameters(*find_law("neo_hookean"))));
    return particle_balance<D>(grid.particles, laws, grid.plan, transfer->affine(), Vec<D>::Zero(), grid.parallel);
  }
  Grid<D> grid;
  std::unique_ptr<Transfer<D>> transfer;
  Particles<D> start;
  Balance before, after;
};

template <int D>
Vec3 angular_of_grid(const Grid<D>& grid) {
  return grid_angular_momentum<D>(grid.plan, grid.state.momentum, 0, grid.state.momentum);
}

}  // namespace

TEST_CASE("transfers keep linear momentum to rounding") {
  for_all([](auto d, const BasisInfo& basis, const TransferInfo& transfer) {
    constexpr int D = d;
    const RoundTrip<D> trip(test::scattered<D>(200, dx, 0.35, 101), basis, transfer.name);
    Vec<D> on_grid = Vec<D>::Zero();
    for (int i = 0; i < trip.grid.plan.node_count(); ++i)
      on_grid += trip.grid.state.momentum.template segment<D>(i * D);
    double size = 0;
    for (std::size_t p = 0; p < trip.start.size(); ++p) size += trip.start.mass[p] * trip.start.v[p].norm();
    CHECK((on_grid - trip.before.momentum.template head<D>()).norm() < 1e-13 * size);
    CHECK((trip.after.momentum - trip.before.momentum).norm() < 1e-13 * size);
  });
}

TEST_CASE("APIC keeps angular momentum to rounding on the way to the grid and back; PIC does not") {
  for_all([](auto d, const BasisInfo& basis, const TransferInfo& transfer) {
    constexpr int D = d;
    const RoundTrip<D> trip(general<D>(200, 103), basis, transfer.name, 0.5);
    const double size = trip.before.angular_momentum.norm() + 1e-3 * trip.before.kinetic;
    CHECK((angular_of_grid<D>(trip.grid) - trip.before.angular_momentum).norm() < 1e-12 * size);
    const double lost = (trip.after.angular_momentum - trip.before.angular_momentum).norm();
    if (transfer.name == "apic") CHECK(lost < 1e-12 * size);
    if (transfer.name == "pic") CHECK(lost > 1e-4 * size);
  });
}

TEST_CASE("APIC carries an affine velocity field to the grid and back unchanged") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    Particles<3> particles = general<3>(150, 107);
    test::Random random(3);
    const Mat<3> A = random.matrix<3>(2);
    const Vec<3> b = random.vector<3>(1);
    for (std::size_t p = 0; p < particles.size(); ++p) {
      particles.v[p] = A * particles.x[p] + b;
      particles.C[p] = A;
    }
    const RoundTrip<3> trip(std::move(particles), basis, "apic");
    double worst = 0;
    for (std::size_t p = 0; p < trip.start.size(); ++p)
      worst =
          std::max({worst, (trip.grid.particles.v[p] - trip.start.v[p]).norm(), (trip.grid.particles.C[p] - A).norm()});
    // Nodes with next to no mass amplify rounding in what is divided by it.
    CHECK(worst < 1e-9);
    for (int i = 0; i < trip.grid.plan.node_count(); ++i)
      if (trip.grid.state.mass[i] > 1e-6 * trip.grid.state.mass.maxCoeff())
        CHECK((trip.grid.state.v.segment<3>(i * 3) - (A * trip.grid.plan.node_position(i) + b)).norm() < 1e-8);
  }
}

TEST_CASE("no transfer adds kinetic energy, all FLIP changes none, and a uniform velocity is kept by all") {
  for_all([](auto d, const BasisInfo& basis, const TransferInfo& transfer) {
    constexpr int D = d;
    const RoundTrip<D> trip(general<D>(200, 109), basis, transfer.name, 1);
    CHECK(trip.after.kinetic <= trip.before.kinetic * (1 + 1e-13));
    if (transfer.name == "flip") CHECK(trip.after.kinetic == doctest::Approx(trip.before.kinetic).epsilon(1e-13));
    if (transfer.name == "pic") CHECK(trip.after.kinetic < 0.9 * trip.before.kinetic);
    Particles<D> uniform = test::scattered<D>(100, dx, 0.35, 113);
    for (Vec<D>& v : uniform.v) v.setConstant(0.3);
    for (Mat<D>& C : uniform.C) C.setZero();
    const RoundTrip<D> steady(std::move(uniform), basis, transfer.name);
    for (const Vec<D>& v : steady.grid.particles.v) CHECK((v - Vec<D>::Constant(0.3)).norm() < 1e-14);
  });
}

TEST_CASE("the blend is (1 - a) PIC + a FLIP") {
  for (const BasisInfo& basis : bases()) {
    const RoundTrip<2> pic(general<2>(80, 127), basis, "pic"), blend(general<2>(80, 127), basis, "flip", 0.3);
    for (std::size_t p = 0; p < pic.start.size(); ++p)
      CHECK((blend.grid.particles.v[p] - (0.7 * pic.grid.particles.v[p] + 0.3 * pic.start.v[p])).norm() < 1e-14);
  }
}

TEST_CASE("the consistent velocity is the least-squares fit to the particles, and a blend when they are too few") {
  for (const BasisInfo& basis : bases())
    for (const int count : {1, 3, 200}) {
      CAPTURE(basis.name);
      CAPTURE(count);
      Grid<2> grid(count == 200 ? jittered(14) : general<2>(count, 131), basis.name, dx);
      const MassMatrix<2> M(grid.plan, grid.particles, grid.state.mass, {true}, grid.parallel, grid.work);
      lumped_velocity(grid.plan, grid.particles, grid.state);
      double residual = 1;
      M.solve(grid.state.momentum, grid.state.v, residual);
      CHECK(residual < 1e-9);
      CHECK(grid.state.v.allFinite());
      if (M.blend() > 0) continue;  // fewer particles than nodes: no longer the fit alone
      std::vector<Vec<2>> fit(grid.particles.size());
      const auto at_particles = [&](const Vector& v, std::vector<Vec<2>>& values) {
        GridState<2> state;
        state.v_end = v;
        make_transfer<2>("flip", 0)->grid_to_particles(grid.plan, state, grid.particles, grid.parallel,
                                                       {nullptr, values.data(), nullptr, nullptr});
      };
      const auto misfit = [&](const Vector& v) {
        at_particles(v, fit);
        double sum = 0;
        for (std::size_t p = 0; p < fit.size(); ++p)
          sum += grid.particles.mass[p] * (fit[p] - grid.particles.v[p]).squaredNorm();
        return sum;
      };
      const double best = misfit(grid.state.v);
      CHECK(std::isfinite(best));
      test::Random random(7);
      for (int k = 0; k < 20; ++k)
        CHECK(misfit(grid.state.v + random.values(grid.unknowns(), 0.05)) >= best - 1e-13 * grid.state.mass.sum());
      // Fitted a second time nothing changes: PIC with this velocity does not damp.
      at_particles(grid.state.v, fit);
      Vector refit = Vector::Zero(grid.unknowns()), b = Vector::Zero(grid.unknowns());
      std::vector<Vec<2>> momenta(fit.size());
      for (std::size_t p = 0; p < fit.size(); ++p) momenta[p] = grid.particles.mass[p] * fit[p];
      scatter_field<2>(grid.plan, momenta, grid.parallel, b);
      M.solve(b, refit, residual);
      std::vector<Vec<2>> again(fit.size());
      at_particles(refit, again);
      for (std::size_t p = 0; p < fit.size(); ++p) CHECK((again[p] - fit[p]).norm() < 1e-9);
    }
}

TEST_CASE("moving particles along an affine field moves them and their F exactly, on faces too") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    Grid<3> grid(test::scattered<3>(120, dx, 0.3, 137), basis.name, dx);
    const Particles<3> before = grid.particles;
    const Mat<3> A = Mat<3>::Identity() + test::Random(5).matrix<3>(0.2);
    const Vec<3> b(0.1, -0.2, 0.3);
    Vector& u = grid.state.u;
    u.resize(grid.unknowns());
    for (int i = 0; i < grid.plan.node_count(); ++i)
      u.segment<3>(i * 3) = (A - Mat<3>::Identity()) * grid.plan.node_position(i) + b;
    grid.state.v = grid.state.v_end = Vector::Zero(grid.unknowns());
    Scratch memory;
    Motion<3> moved = apart<3>(before.size(), false, memory);
    REQUIRE(grid.plan.foresee(grid.particles, u, moved, grid.parallel));
    const StateCheck check =
        make_transfer<3>("flip", 0)->grid_to_particles(grid.plan, grid.state, grid.particles, grid.parallel, moved);
    CHECK(grid.particles.x == before.x);
    CHECK(grid.particles.F == before.F);
    grid.plan.follow(grid.particles, moved, grid.parallel);
    StateCheck expected{.min_J = INFINITY, .max_J = -INFINITY};
    std::map<std::uint32_t, std::size_t> old;
    for (std::size_t p = 0; p < before.size(); ++p) old[before.id[p]] = p;
    for (std::size_t p = 0; p < before.size(); ++p) {
      const std::size_t q = old.at(grid.particles.id[p]);
      CHECK((grid.particles.x[p] - (A * before.x[q] + b)).norm() < 1e-14);
      CHECK((grid.particles.F[p] - A * before.F[q]).norm() < 1e-13);
      const double J = grid.particles.F[p].determinant();
      expected.include({true, J, J, 0});
    }
    CHECK(check.finite);
    CHECK(check.min_J == doctest::Approx(expected.min_J).epsilon(1e-13));
    CHECK(check.max_J == doctest::Approx(expected.max_J).epsilon(1e-13));
    CHECK(check.max_speed == 0);
  }
}
