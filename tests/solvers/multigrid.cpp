// Multigrid: its matrices are the Hessian's, its cycle is symmetric and positive, its iterations hardly grow.
#include "core/solvers/multigrid.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include "core/energies/inertia.hpp"
#include "core/integrators/potential.hpp"
#include "core/solvers/two_scale.hpp"
#include "tests/energies/terms.hpp"
#include "tests/numerics.hpp"

using namespace pf;
using test::Grid;

namespace {

constexpr double dx = 0.1;

/// The whole symmetric matrix, row by row of the layout.
template <int D>
Eigen::MatrixXd dense(const StencilMatrix<D>& A) {
  const StencilLayout<D>& layout = *A.layout;
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(layout.rows() * D, layout.rows() * D);
  for (int i = 0; i < layout.rows(); ++i) {
    for (int a = 0; a < D; ++a)
      for (int c = 0; c < D; ++c) full(i * D + a, i * D + c) = A.diagonal_block(i)[a + D * c];
    for (int l = 0; l < layout.lines(); ++l)
      for (int k = 0; layout.windows(i)[l] >= 0 && k <= 2 * layout.reach(); ++k) {
        const int j = layout.row_at(layout.windows(i)[l] + k);
        const float* entries = A.row(i) + l * D * A.width + k * D;
        for (int a = 0; a < D; ++a)
          for (int c = 0; c < D; ++c) {
            if (j < 0 || j >= i) {
              CHECK(entries[a * A.width + c] == 0);
              continue;
            }
            full(i * D + a, j * D + c) = full(j * D + c, i * D + a) = entries[a * A.width + c];
          }
      }
  }
  return full;
}

/// P of a level and its coarser one, from the definition: the two-scale relation of the splines.
template <int D, int R>
Eigen::MatrixXd prolongation(const StencilLayout<D>& fine, const StencilLayout<D>& coarse) {
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(fine.rows() * D, coarse.rows() * D);
  for (const LatticeRun& f : fine.runs())
    for (const LatticeRun& c : coarse.runs())
      for (int x = f.begin; x < f.end; ++x)
        for (int X = c.begin; X < c.end; ++X) {
          const auto i = StencilLayout<D>::point(f.line, x), I = StencilLayout<D>::point(c.line, X);
          double part = 1;
          for (std::size_t k = 0; k < D; ++k) part *= part_in<R>(i[k], I[k]);
          for (int a = 0; a < D; ++a) P((f.row + x - f.begin) * D + a, (c.row + X - c.begin) * D + a) = part;
        }
  return P;
}

/// An elastic body in a strained state, and the potential of one step.
template <int D>
struct Step {
  Step(Particles<D> particles, std::string_view basis, int threads = 1, bool share_volume = false)
      : grid(std::move(particles), basis, dx, threads),
        mass(grid.plan, grid.particles, grid.state.mass, {}, grid.parallel, grid.work),
        inertia(mass, Vector::Zero(grid.unknowns()), 0.01),
        elastic(grid.plan, grid.particles, grid.laws, grid.parallel, grid.work),
        potential(grid.plan, grid.state.mass, set, {&inertia, &elastic}, {}) {
    grid.use_law(*find_law("neo_hookean"));
    grid.laws.back()->share_volume(share_volume);
    const Vector u = test::Random(5).values(grid.unknowns(), 0.02 * dx);
    potential.gradient(u, g);
    potential.prepare_hessian(u, true);
  }
  LinearProblem<D> problem() { return {potential, set, directions, g, 1e-6, nullptr}; }

  Grid<D> grid;
  FeasibleSet<D> set;
  std::vector<Mat<D>> directions;
  MassMatrix<D> mass;
  Inertia<D> inertia;
  ElasticEnergy<D> elastic;
  IncrementalPotential<D> potential;
  Vector g;
};

template <class F>
void for_bases(F&& f) {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    f(std::integral_constant<int, 2>{}, basis.name);
    f(std::integral_constant<int, 3>{}, basis.name);
  }
}

}  // namespace

TEST_CASE("the stencil matrix is the Hessian, for scattered particles, every basis, 2D and 3D, with F-bar too") {
  for (const bool shared : {false, true})
    for_bases([shared](auto d, std::string_view basis) {
      constexpr int D = d;
      Step<D> step(test::scattered<D>(60, dx, D == 2 ? 0.6 : 0.3, 3), basis, 1, shared);
      StencilLayout<D> layout;
      std::vector<std::int32_t> row_of;
      const Lattice<D> lattice = step.potential.lattice();
      layout.build(lattice.index, lattice.reach, row_of);
      StencilMatrix<D> A;
      A.shape(layout);
      step.potential.assemble_stencil(A, row_of);
      const Eigen::MatrixXd found = dense(A);
      BlockMatrix<D> H;
      step.potential.assemble(H);
      const Eigen::MatrixXd expected = test::dense(H);
      const double size = expected.cwiseAbs().maxCoeff();
      for (int i = 0; i < expected.rows(); ++i)
        for (int j = 0; j < expected.cols(); ++j) {
          const double there = found(row_of[static_cast<std::size_t>(i / D)] * D + i % D,
                                     row_of[static_cast<std::size_t>(j / D)] * D + j % D);
          if (std::abs(there - expected(i, j)) > 2e-6 * size) FAIL_CHECK("differs: " << there << " " << expected(i, j));
        }
    });
}

TEST_CASE("a coarse level is P^T A P, for scattered particles, every basis, 2D and 3D") {
  for_bases([](auto d, std::string_view basis) {
    constexpr int D = d;
    Step<D> step(test::scattered<D>(40, dx, D == 2 ? 0.6 : 0.25, 4), basis);
    MultigridLevel<D> fine, coarse;
    std::vector<std::int32_t> row_of;
    const Lattice<D> lattice = step.potential.lattice();
    fine.layout.build(lattice.index, lattice.reach, row_of);
    fine.resize();
    fine.A.shape(fine.layout);
    step.potential.assemble_stencil(fine.A, row_of);
    fine.connect(coarse);
    fine.coarsen(coarse, step.grid.parallel);
    with_reach(lattice.reach, [&](auto r) {
      const Eigen::MatrixXd P = prolongation<D, r>(fine.layout, coarse.layout);
      const Eigen::MatrixXd expected = P.transpose() * dense(fine.A) * P, found = dense(coarse.A);
      CHECK((found - expected).cwiseAbs().maxCoeff() < 1e-5 * expected.cwiseAbs().maxCoeff());
      // Splines add up to one on both levels.
      const Vector ones = P * Vector::Ones(P.cols());
      CHECK((ones.array() - 1).abs().maxCoeff() < 1e-6);
    });
  });
}

TEST_CASE("the cycle is symmetric and positive definite, also with held and sliding nodes, with patches or without") {
  for_bases([](auto d, std::string_view basis) {
    constexpr int D = d;
    Step<D> step(test::scattered<D>(D == 2 ? 150 : 250, dx, D == 2 ? 0.8 : 0.45, 6), basis);
    test::Random random(8);
    for (int node = 0; node < step.grid.plan.node_count(); node += 5) {
      NodeConstraint<D> c;
      c.node = node;
      Mat<D> Q = Mat<D>::Zero();
      if (node % 2 == 0) {
        const Vec<D> n = random.vector<D>(1).normalized();
        Q = Mat<D>::Identity() - n * n.transpose();
      }
      c.free = Q;
      step.set.constrained.push_back(c);
      step.directions.push_back(Q);
    }
    Multigrid<D> multigrid(step.grid.parallel);
    const LinearProblem<D> problem = step.problem();
    multigrid.prepare(problem);
    for (int k = 0; k < 10; ++k) {
      if (k == 5) REQUIRE(multigrid.strengthen());
      Vector a = random.values(step.grid.unknowns(), 1), b = random.values(step.grid.unknowns(), 1), Ba, Bb;
      step.set.restrict_to(step.directions, a);
      step.set.restrict_to(step.directions, b);
      multigrid.apply(problem, a, Ba);
      multigrid.apply(problem, b, Bb);
      REQUIRE(Ba.allFinite());
      const double size = std::sqrt(a.dot(Ba) * b.dot(Bb));
      CHECK(a.dot(Ba) > 0);
      CHECK(std::abs(a.dot(Bb) - b.dot(Ba)) < 1e-4 * size);
    }
  });
}

TEST_CASE("a cycle does not depend on the number of threads, to the bit") {
  Vector z[3], strong[3];
  for (int threads = 1; threads <= 3; ++threads) {
    Particles<3> particles;
    for (int k = 0; k < 30; ++k)
      for (int j = 0; j < 14; ++j)
        for (int i = 0; i < 12; ++i) test::add_particle<3>(particles, 0.1 * Vec3(i + 0.3, j + 0.6, k + 0.4), 1, 1e-3);
    Step<3> step(std::move(particles), "quadratic", threads);
    Multigrid<3> multigrid(step.grid.parallel);
    const LinearProblem<3> problem = step.problem();
    multigrid.prepare(problem);
    multigrid.apply(problem, step.g, z[threads - 1]);
    multigrid.strengthen();
    multigrid.apply(problem, step.g, strong[threads - 1]);
  }
  CHECK(z[0] != strong[0]);
  CHECK(strong[0] == strong[1]);
  CHECK(strong[0] == strong[2]);
  CHECK(z[0] == z[1]);
  CHECK(z[0] == z[2]);
}
