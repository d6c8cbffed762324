// Newton's method on the incremental potential (THEORY T4): what it promises on return, for every law and linear
// solver.
#include "core/solvers/newton.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include "core/energies/external.hpp"
#include "core/energies/friction.hpp"
#include "core/energies/inertia.hpp"
#include "core/integrators/potential.hpp"
#include "tests/numerics.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.1;

/// A block of `cells` cells an axis with its low corner at the origin, 2 particles a cell and axis.
template <int D>
Particles<D> block(int cells) {
  Particles<D> particles;
  const int n = 2 * cells;
  for (int k = 0; k < (D == 3 ? n : 1); ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        Vec<D> x;
        x[0] = (i + 0.5) * dx / 2;
        x[1] = (j + 0.5) * dx / 2;
        if constexpr (D == 3) x[2] = (k + 0.5) * dx / 2;
        const double volume = std::pow(dx / 2, D);
        test::add_particle<D>(particles, x, 1000 * volume, volume);
      }
  return particles;
}

/// The potential of one backward Euler step of a block.
template <int D>
struct Problem {
  Problem(const LawInfo& law, int cells, double dt, std::function<Vec<D>(const Vec<D>&)> velocity,
          std::string_view basis = "quadratic", bool consistent = false)
      : grid(block<D>(cells), basis, dx),
        mass(grid.plan, grid.particles, grid.state.mass, {consistent}, grid.parallel, grid.work),
        elastic(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work),
        friction(set),
        external(force) {
    grid.use_law(law);
    v.resize(grid.unknowns());
    for (int i = 0; i < grid.plan.node_count(); ++i) v.segment<D>(i * D) = velocity(grid.plan.node_position(i));
    force = Vector::Zero(v.size());
    inertia = std::make_unique<Inertia<D>>(mass, v, dt);
  }

  NewtonResult solve(std::string_view solver, const NewtonSettings& settings = {}) {
    Vector free_flight;
    inertia->free_flight_force(free_flight);
    potential = std::make_unique<IncrementalPotential<D>>(
        grid.plan, grid.state.mass, set, std::vector<Energy<D>*>{inertia.get(), &elastic, &external, &friction},
        std::vector<const Vector*>{&free_flight, &force});
    const auto linear = make_linear_solver<D>(solver, grid.parallel);
    u = Vector::Zero(v.size());
    return minimise<D>(*potential, set, *linear, settings, nullptr, u);
  }
  /// T4's criterion, evaluated afresh.
  double residual() {
    Vector g;
    potential->gradient(u, g);
    ActiveSet<D> active;
    set.active_set(u, g, active);
    return potential->norm(g) / potential->scale();
  }
  double smallest_J() {
    double J = 1e300;
    for (const Mat<D>& F : elastic.deformed(u)) J = std::min(J, F.determinant());
    return J;
  }

  Grid<D> grid;
  MassMatrix<D> mass;
  ElasticEnergy<D> elastic;
  FeasibleSet<D> set;
  Friction<D> friction;
  Vector v, force, u;
  ExternalWork<D> external;
  std::unique_ptr<Inertia<D>> inertia;
  std::unique_ptr<IncrementalPotential<D>> potential;
};

std::vector<std::string_view> solvers() {
  std::vector<std::string_view> names;
  for (const LinearSolverInfo& info : linear_solvers())
    if (info.name != "auto") names.push_back(info.name);
  return names;
}

void check_promises(const NewtonResult& result, double residual, double tolerance) {
  CHECK(result.status == NewtonStatus::converged);
  CHECK(result.residual <= tolerance);
  CHECK(residual <= tolerance * (1 + 1e-6));
  REQUIRE_FALSE(result.iterations.empty());
  for (std::size_t k = 1; k < result.iterations.size(); ++k) {
    const double before = result.iterations[k - 1].energy, after = result.iterations[k].energy;
    // Near the end differences of E are rounding; the record says where.
    const double rounding = result.iterations[k - 1].residual_search ? 1e-11 * std::abs(before) : 0;
    CHECK(after <= before + rounding);
  }
}

/// Squeezes, shears and spins: the far side moves by more than a cell a step.
template <int D>
Vec<D> violent(const Vec<D>& x) {
  Vec<D> v = Vec<D>::Zero();
  v[0] = -25 * x[0] + 12 * x[1];
  v[1] = 8 * std::sin(9 * x[0]);
  return v;
}

/// A floor at y = 0 with friction, a held corner column at x <= 0, and weight.
template <int D>
void stand_on_floor(Problem<D>& problem) {
  for (int i = 0; i < problem.grid.plan.node_count(); ++i) {
    const Vec<D> x = problem.grid.plan.node_position(i);
    problem.force.template segment<D>(i * D) = -9.81 * problem.grid.state.mass[i] * Vec<D>::UnitY();
    NodeConstraint<D> c;
    c.node = i;
    if (x[1] < 1e-9) {
      c.faces = 1;
      c.normal[0] = c.rub_normal = Vec<D>::UnitY();
      c.rub_bound = 0.5;
      c.friction = 0.3;
    }
    if (x[0] < 1e-9) {
      c.free(0, 0) = 0;
      c.given[0] = 0.001;
    }
    if (c.faces > 0 || c.free(0, 0) == 0) problem.set.constrained.push_back(c);
  }
}

}  // namespace

TEST_CASE("Newton returns below its tolerance and energy never rises, from a start of large velocity") {
  for (const LawInfo& law : laws())
    for (const std::string_view solver : solvers())
      for (const double tolerance : {1e-4, 1e-9}) {
        CAPTURE(law.name);
        CAPTURE(solver);
        CAPTURE(tolerance);
        Problem<2> flat(law, 4, 0.02, violent<2>);
        const NewtonResult result = flat.solve(solver, {tolerance, 200});
        check_promises(result, flat.residual(), tolerance);
        if (law.barrier_at_zero) CHECK(flat.smallest_J() > 0);
      }
}

TEST_CASE("Newton in 3D: the same promises") {
  for (const LawInfo& law : laws())
    for (const std::string_view solver : solvers()) {
      CAPTURE(law.name);
      CAPTURE(solver);
      Problem<3> solid(law, 2, 0.02, violent<3>);
      const NewtonResult result = solid.solve(solver, {1e-7, 200});
      check_promises(result, solid.residual(), 1e-7);
      if (law.barrier_at_zero) CHECK(solid.smallest_J() > 0);
    }
}

TEST_CASE("every linear solver leads to the same minimum, with lumped and consistent inertia") {
  for (const BasisInfo& basis : bases())
    for (const bool consistent : {false, true}) {
      CAPTURE(basis.name);
      CAPTURE(consistent);
      std::vector<Vector> found;
      for (const std::string_view solver : solvers()) {
        const auto shear = [](const Vec<2>& x) { return Vec<2>(-3 * x[1], 2 * x[0] * x[0]); };
        Problem<2> problem(*find_law("neo_hookean"), 4, 0.01, shear, basis.name, consistent);
        const NewtonResult result = problem.solve(solver, {1e-10, 100});
        CHECK(result.status == NewtonStatus::converged);
        found.push_back(problem.u);
      }
      for (const Vector& u : found) CHECK((u - found[0]).norm() < 1e-7 * found[0].norm());
    }
}

TEST_CASE("constraints, contact and friction: the minimum is feasible, the residual small, solvers agree") {
  std::vector<Vector> found;
  for (const std::string_view solver : solvers()) {
    CAPTURE(solver);
    Problem<2> problem(*find_law("neo_hookean"), 5, 0.01, [](const Vec<2>& x) { return Vec<2>(1 + x[1], -0.5); });
    stand_on_floor(problem);
    const NewtonResult result = problem.solve(solver, {1e-10, 100});
    check_promises(result, problem.residual(), 1e-10);
    int stuck = 0, pressed = 0;
    for (const NodeConstraint<2>& c : problem.set.constrained) {
      const Vec<2> u = problem.u.segment<2>(c.node * 2);
      if (c.faces > 0) CHECK(u[1] >= -1e-15);
      if (c.faces > 0) pressed += u[1] <= 1e-15;
      if (c.free(0, 0) == 0) CHECK(u[0] == doctest::Approx(0.001).epsilon(1e-13));
      if (c.rub_bound > 0 && c.free(0, 0) == 1) stuck += u[0] == 0;
    }
    CHECK(pressed > 3);
    found.push_back(problem.u);
  }
  for (const Vector& u : found) CHECK((u - found[0]).norm() < 1e-7 * found[0].norm());
}

TEST_CASE("no feasible neighbour of the minimum has a lower energy") {
  Problem<2> problem(*find_law("fixed_corotated"), 4, 0.01, [](const Vec<2>& x) { return Vec<2>(x[1], -1); });
  stand_on_floor(problem);
  REQUIRE(problem.solve("direct", {1e-11, 100}).status == NewtonStatus::converged);
  const double least = problem.potential->value(problem.u);
  test::Random random(11);
  for (const double size : {1e-2, 1e-4})
    for (int k = 0; k < 50; ++k) {
      Vector other = problem.u + random.values(problem.u.size(), size * dx);
      problem.set.project(other);
      CHECK(problem.potential->value(other) > least);
    }
}

TEST_CASE("negative curvature leads to projection, and the solve still converges") {
  // A strip crushed to 60 % of its length in one step is past buckling: the Hessian at the straight state is
  // indefinite.
  for (const std::string_view solver : solvers())
    for (const std::string_view law : {"neo_hookean", "st_venant_kirchhoff", "hencky"}) {
      CAPTURE(solver);
      CAPTURE(law);
      Problem<2> problem(*find_law(law), 6, 0.5, [](const Vec<2>&) { return Vec<2>(0, 0); });
      for (Mat<2>& F : problem.grid.particles.F) F = Vec<2>(0.5, 1.05).asDiagonal();
      const NewtonResult result = problem.solve(solver, {1e-8, 300});
      check_promises(result, problem.residual(), 1e-8);
      const auto projected = [](const NewtonIteration& it) { return it.projected > 0 && it.projected <= 1; };
      CHECK(std::any_of(result.iterations.begin(), result.iterations.end(), projected));
    }
}

TEST_CASE("the Hessian is projected where the residual is large, and no more than it takes") {
  // A long strip, crushed and skewed at one end only: the other end has no part in what is indefinite.
  for (const std::string_view solver : solvers()) {
    CAPTURE(solver);
    Problem<2> problem(*find_law("neo_hookean"), 24, 0.1, [](const Vec<2>&) { return Vec<2>(0, 0); });
    Particles<2>& particles = problem.grid.particles;
    double end = 0;
    for (const Vec<2>& x : particles.x) end = std::max(end, x[0]);
    for (std::size_t p = 0; p < particles.size(); ++p)
      if (particles.x[p][0] > 0.85 * end) particles.F[p] = Vec<2>(0.4, 1.1).asDiagonal();
    const NewtonResult result = problem.solve(solver, {1e-8, 300});
    check_promises(result, problem.residual(), 1e-8);
    double least = 1, most = 0;
    for (const NewtonIteration& it : result.iterations) {
      most = std::max(most, it.projected);
      if (it.projected > 0) least = std::min(least, it.projected);
    }
    CHECK(most > 0);
    CHECK(least < 0.3);
  }
}

TEST_CASE("a prescribed motion that turns material inside out is an infeasible start, not a crash") {
  Problem<2> problem(*find_law("neo_hookean"), 3, 0.01, [](const Vec<2>&) { return Vec<2>(0, 0); });
  for (int i = 0; i < problem.grid.plan.node_count(); ++i) {
    NodeConstraint<2> c;
    c.node = i;
    c.free.setZero();
    c.given[0] = -3 * problem.grid.plan.node_position(i)[0];  // a reflection
    problem.set.constrained.push_back(c);
  }
  CHECK(problem.solve("pcg_jacobi").status == NewtonStatus::infeasible_start);
}

TEST_CASE("a problem without any force is solved where it stands") {
  for (const std::string_view solver : solvers()) {
    Problem<2> problem(*find_law("neo_hookean"), 3, 0.01, [](const Vec<2>&) { return Vec<2>(0, 0); });
    const NewtonResult result = problem.solve(solver);
    CHECK(result.status == NewtonStatus::converged);
    CHECK(problem.u.norm() < 1e-15);
  }
}

TEST_CASE("too few iterations are reported as such, with the best iterate") {
  Problem<2> problem(*find_law("neo_hookean"), 4, 0.02, violent<2>);
  const NewtonResult result = problem.solve("pcg_jacobi", {1e-12, 2});
  CHECK(result.status == NewtonStatus::not_converged);
  CHECK(result.iterations.size() == 3);
  CHECK(result.iterations.back().energy < result.iterations.front().energy);
}

TEST_CASE("without line search every step is taken whole, the energy may rise, and where it ends so does the solve") {
  bool rises = false, ends = false;
  for (const LawInfo& law : laws()) {
    CAPTURE(law.name);
    // Half a turn: to first order that is a stretch to three times the size.
    Problem<2> problem(law, 4, 0.1, [](const Vec<2>& x) { return Vec<2>(-30 * (x[1] - 0.2), 30 * (x[0] - 0.2)); });
    const NewtonResult result = problem.solve("direct", {1e-9, 60, false});
    for (std::size_t k = 0; k + 1 < result.iterations.size(); ++k) {
      CHECK(result.iterations[k].step_length == 1);
      rises |= result.iterations[k + 1].energy > result.iterations[k].energy + 1e-9 * problem.potential->energy_scale();
    }
    ends |= result.status == NewtonStatus::not_finite;
    CHECK(std::isfinite(problem.residual()));
  }
  CHECK((rises || ends));
  // Close to the solution both are the same.
  Problem<2> with(*find_law("neo_hookean"), 4, 1e-4, violent<2>),
      without(*find_law("neo_hookean"), 4, 1e-4, violent<2>);
  CHECK(with.solve("direct", {1e-9, 20, true}).status == NewtonStatus::converged);
  CHECK(without.solve("direct", {1e-9, 20, false}).status == NewtonStatus::converged);
  CHECK(with.u == without.u);
}

TEST_CASE("cancelling leaves at once") {
  Problem<2> problem(*find_law("neo_hookean"), 4, 0.02, violent<2>);
  problem.solve("pcg_jacobi");  // makes the potential
  for (const std::string_view solver : solvers()) {
    const std::atomic<bool> cancel = true;
    const auto linear = make_linear_solver<2>(solver, problem.grid.parallel);
    Vector u = Vector::Zero(problem.v.size());
    CHECK(minimise<2>(*problem.potential, problem.set, *linear, {}, &cancel, u).status == NewtonStatus::cancelled);
  }
}
