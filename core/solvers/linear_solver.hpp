// H p = -g on the free directions: what Newton's method asks of a linear solver.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "core/math/parallel.hpp"
#include "core/solvers/feasible_set.hpp"
#include "core/solvers/objective.hpp"

namespace pf {

template <int D>
struct LinearProblem {
  Objective<D>& objective;  ///< its Hessian is prepared
  const FeasibleSet<D>& set;
  const std::vector<Mat<D>>& directions;  ///< of set.active_directions
  const Vector& g;                        ///< restricted to the directions
  double tolerance;                       ///< relative, in the preconditioner's norm; a direct solver ignores it
  const std::atomic<bool>* cancel;
  bool same_hessian = false;  ///< as in the last solve: only directions and g have changed
};

struct LinearResult {
  int iterations = 0;
  bool negative_curvature = false;  ///< H is not positive definite on the free directions; p is not to be used
  bool cancelled = false;
};

/// Multiply-adds, for Work.
struct SolverWork {
  std::uint64_t operations = 0;          ///< in double precision, in vectors and in factors with column indices
  std::uint64_t stencil_operations = 0;  ///< in single precision, in stencil matrices by whole vector registers
  SolverWork& operator+=(const SolverWork& more) {
    operations += more.operations;
    stencil_operations += more.stencil_operations;
    return *this;
  }
};

template <int D>
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  virtual std::string_view name() const = 0;
  virtual LinearResult solve(const LinearProblem<D>& problem, Vector& p) = 0;
  /// The step's nodes have changed: forget what depends on them.
  virtual void new_step() {}
  /// What was done since the last call, Hessian products and the assembly of particles left out.
  SolverWork take_work() { return std::exchange(work_, {}); }

 protected:
  SolverWork work_;  ///< to be added to by solve()
};

/// A linear solver as the menu knows it.
struct LinearSolverInfo {
  std::string_view name, label, about;
};
/// "auto" first.
std::span<const LinearSolverInfo> linear_solvers();
/// Not for "auto". Throws std::invalid_argument for an unknown name.
template <int D>
std::unique_ptr<LinearSolver<D>> make_linear_solver(std::string_view name, Parallel& parallel);

extern template std::unique_ptr<LinearSolver<2>> make_linear_solver<2>(std::string_view, Parallel&);
extern template std::unique_ptr<LinearSolver<3>> make_linear_solver<3>(std::string_view, Parallel&);

}  // namespace pf
