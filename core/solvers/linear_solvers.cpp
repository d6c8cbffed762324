#include <array>
#include <stdexcept>
#include <string>

#include "core/solvers/block_jacobi.hpp"
#include "core/solvers/direct.hpp"
#include "core/solvers/incomplete_cholesky.hpp"
#include "core/solvers/multigrid.hpp"
#include "core/solvers/pcg.hpp"

namespace pf {

namespace {
constexpr std::array<LinearSolverInfo, 5> registry{{
    {"auto", "Automatic", "Conjugate gradients; in 2D the direct solver once the counted iterations make it cheaper."},
    {"pcg_jacobi", "Conjugate gradients, block-Jacobi", "Matrix-free; best for soft or large scenes."},
    {"pcg_ic", "Conjugate gradients, incomplete Cholesky", "For 2D scenes of middling stiffness; one thread."},
    {"pcg_multigrid", "Conjugate gradients, multigrid",
     "Iterations hardly grow with stiffness or a finer grid; best for stiff or large scenes."},
    {"direct", "Direct (sparse Cholesky)", "Exact and unmoved by stiffness; best for small 2D scenes."},
}};
}  // namespace

std::span<const LinearSolverInfo> linear_solvers() {
  return registry;
}

template <int D>
std::unique_ptr<Preconditioner<D>> make_preconditioner(std::string_view name, Parallel& parallel) {
  if (name == "pcg_jacobi") return std::make_unique<BlockJacobi<D>>(parallel);
  if (name == "pcg_ic") return std::make_unique<IncompleteCholesky<D>>();
  if (name == "pcg_multigrid") return std::make_unique<Multigrid<D>>(parallel);
  return nullptr;
}

template <int D>
std::unique_ptr<LinearSolver<D>> make_linear_solver(std::string_view name, Parallel& parallel) {
  for (const LinearSolverInfo& info : registry)
    if (info.name == name)
      if (auto preconditioner = make_preconditioner<D>(name, parallel))
        return std::make_unique<Pcg<D>>(info.name, std::move(preconditioner), parallel);
  if (name == "direct") return std::make_unique<DirectSolver<D>>();
  throw std::invalid_argument("unknown linear solver " + std::string(name));
}

template std::unique_ptr<Preconditioner<2>> make_preconditioner<2>(std::string_view, Parallel&);
template std::unique_ptr<Preconditioner<3>> make_preconditioner<3>(std::string_view, Parallel&);
template std::unique_ptr<LinearSolver<2>> make_linear_solver<2>(std::string_view, Parallel&);
template std::unique_ptr<LinearSolver<3>> make_linear_solver<3>(std::string_view, Parallel&);

}  // namespace pf
