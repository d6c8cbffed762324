#include "core/bench/kernels.hpp"

#include "core/bench/body.hpp"
#include "core/bench/clock.hpp"
#include "core/energies/inertia.hpp"
#include "core/solvers/preconditioner.hpp"

namespace pf::bench {

namespace {

template <int D>
class Kernels {
 public:
  Kernels(std::string_view basis, std::size_t about_particles, int threads, double budget)
      : body_(basis, about_particles, threads), K_(body_.basis.nodes_per_axis), budget_(budget) {
    result_.dimension = D;
    result_.basis = basis;
    result_.threads = threads;
  }
  KernelCase run();

 private:
  template <class Before, class Kernel>
  void add(const std::string& name, Counts counts, Before&& before, Kernel&& kernel) {
    const Timing time = measure(result_.threads == 1, budget_, 3, before, kernel);
    const double each = 1e9 / static_cast<double>(body_.particles.size());
    result_.kernels.push_back({name, counts, time.median * each, time.least * each, time.repeats});
  }
  template <class Kernel>
  void add(const std::string& name, Counts counts, Kernel&& kernel) {
    add(
        name, counts, [] {}, kernel);
  }
  void plan_and_transfers();
  void elastic();
  void preconditioners(IncrementalPotential<D>& potential, const Vector& g);

  Body<D> body_;
  int K_;
  double budget_;
  KernelCase result_;
};

template <int D>
void Kernels<D>::plan_and_transfers() {
  const double all = 4 * vector_bytes(D) + 2 * matrix_bytes(D) + 2 * 8 + 8;  // every array of a particle, about
  add("plan, order unchanged", {vector_bytes(D) + weight_bytes(D) + 2 + 12, 0}, [&] { body_.build_plan(); });
  add(
      "sort and plan, particles moved", {2 * all + weight_bytes(D) + 24, 0}, [&] { body_.shake(); },
      [&] { body_.build_plan(); });
  particles_to_grid(body_.plan, body_.particles, true, body_.parallel, body_.grid);
  lumped_velocity(body_.plan, body_.particles, body_.grid);
  body_.grid.u = body_.displacements();
  body_.grid.v_end = body_.grid.v;
  const double weights = weight_bytes(D);
  add("P2G, APIC", {weights + 2 * vector_bytes(D) + matrix_bytes(D) + 8, stencil_flops(D, K_, D + 1, true, true)},
      [&] { particles_to_grid(body_.plan, body_.particles, true, body_.parallel, body_.grid); });
  add("P2G, FLIP", {weights + vector_bytes(D) + 8, stencil_flops(D, K_, D + 1, true, false)},
      [&] { particles_to_grid(body_.plan, body_.particles, false, body_.parallel, body_.grid); });
  const std::unique_ptr<Transfer<D>> apic = make_transfer<D>("apic", 0), flip = make_transfer<D>("flip", 0.95);
  const double n2 = 2 * vector_bytes(D), F = 2 * matrix_bytes(D), gradient = stencil_flops(D, K_, D, false, true);
  Scratch memory;
  Motion<D> to = apart<D>(body_.particles.size(), true, memory);
  add("new positions and order", {weights + n2 + 16 + 8, stencil_flops(D, K_, D, true, false)},
      [&] { body_.plan.foresee(body_.particles, body_.grid.u, to, body_.parallel); });
  to.place = nullptr;
  add("G2P, APIC", {weights + n2 + F + matrix_bytes(D), stencil_flops(D, K_, D, true, true) + gradient + 2 * D * D * D},
      [&] { apic->grid_to_particles(body_.plan, body_.grid, body_.particles, body_.parallel, to); });
  add("G2P, FLIP", {weights + n2 + F, stencil_flops(D, K_, D, true, false) + gradient + 2 * D * D * D},
      [&] { flip->grid_to_particles(body_.plan, body_.grid, body_.particles, body_.parallel, to); });
}

template <int D>
void Kernels<D>::elastic() {
  ElasticEnergy<D> elastic(body_.plan, body_.particles, body_.laws, body_.parallel, body_.work);
  const MassMatrix<D> mass(body_.plan, body_.particles, body_.grid.mass, {}, body_.parallel, body_.work);
  Inertia<D> inertia(mass, body_.grid.v, 0.01);
  IncrementalPotential<D> potential(body_.plan, body_.grid.mass, body_.set, {&inertia, &elastic}, {});
  const Vector& u = body_.grid.u;
  Vector g, p = u, Hp(u.size());
  const double weights = weight_bytes(D), F = matrix_bytes(D), product = 2.0 * D * D * D;
  const double gather = stencil_flops(D, K_, D, false, true);
  add("energy", {weights + 2 * F + 16, gather + product}, [&] { potential.value(u); });
  add("residual and energy", {weights + 3 * F + 24, 2 * gather + 2 * product}, [&] { potential.gradient(u, g); });
  const double tangent = 4.0 * tangent_components<D>;
  add("tangents", {2 * F + 8 + tangent, 0}, [&] { potential.prepare_hessian(u, false); });
  add("tangents, projected", {2 * F + 8 + tangent, 0}, [&] { potential.prepare_hessian(u, true); });
  add("Hessian product, particles", {weights + tangent, 2 * gather + 2.0 * D * D * D * D}, [&] {
    Hp.setZero();
    potential.hessian_product(p, Hp);
  });
  std::vector<Mat<D>> blocks(static_cast<std::size_t>(body_.plan.node_count()));
  const double C = D * (D + 1) / 2.0, rows = D == 2 ? K_ : K_ * K_;
  add("block diagonal", {weights + tangent, 2 * C * rows * (6 + 3 * K_)}, [&] {
    std::fill(blocks.begin(), blocks.end(), Mat<D>::Zero());
    potential.diagonal(blocks);
  });
  StencilLayout<D> layout;
  StencilMatrix<D> matrix;
  std::vector<std::int32_t> row_of;
  layout.build(body_.plan.node_indices(), K_ - 1, row_of);
  add("whole matrix, by stencils", {weights + tangent, 0}, [&] {
    matrix.shape(layout);
    potential.assemble_stencil(matrix, row_of);
  });
  preconditioners(potential, g);
  result_.bytes = static_cast<double>(body_.plan.bytes()) + static_cast<double>(body_.particles.size()) * (tangent) +
                  static_cast<double>(body_.particles.size()) * (3 * vector_bytes(D) + 2 * F + 16 + 8);
}

template <int D>
void Kernels<D>::preconditioners(IncrementalPotential<D>& potential, const Vector& g) {
  for (const LinearSolverInfo& solver : linear_solvers()) {
    const auto preconditioner = make_preconditioner<D>(solver.name, body_.parallel);
    if (!preconditioner) continue;
    // Incomplete factors in 3D take minutes, and nobody would use them.
    if (D == 3 && solver.name == "pcg_ic" && body_.particles.size() > 20000) continue;
    const LinearProblem<D> problem{potential, body_.set, {}, g, 0.1, nullptr};
    preconditioner->new_step();
    Vector z(g.size());
    const std::string name = "preconditioner of " + std::string(solver.name);
    add(name + ", prepared", {}, [&] { preconditioner->prepare(problem); });
    preconditioner->take_work();
    preconditioner->apply(problem, g, z);
    const SolverWork work = preconditioner->take_work();
    const double flops = 2 * static_cast<double>(work.operations + work.stencil_operations);
    add(name + ", applied", {0, flops / static_cast<double>(body_.particles.size())},
        [&] { preconditioner->apply(problem, g, z); });
  }
}

template <int D>
KernelCase Kernels<D>::run() {
  plan_and_transfers();
  elastic();
  result_.particles = body_.particles.size();
  result_.nodes = body_.plan.node_count();
  return std::move(result_);
}

}  // namespace

KernelCase measure_kernels(int dimension, std::string_view basis, std::size_t about_particles, int threads,
                           double budget) {
  return dimension == 2 ? Kernels<2>(basis, about_particles, threads, budget).run()
                        : Kernels<3>(basis, about_particles, threads, budget).run();
}

}  // namespace pf::bench
