// z = B^-1 r, B symmetric positive definite and close to H on the free directions: what makes conjugate gradients
// short.
#pragma once

#include "core/solvers/linear_solver.hpp"

namespace pf {

template <int D>
class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  /// Makes B for the Hessian of the problem. One that was made for another Hessian of the same step and the same free
  /// directions serves too, less well.
  virtual void prepare(const LinearProblem<D>& problem) = 0;
  /// What prepare() costs, in iterations.
  virtual int cost() const = 0;
  /// z = B^-1 r; `r` and `z` lie in the free directions, and z depends linearly and symmetrically on r.
  virtual void apply(const LinearProblem<D>& problem, const Vector& r, Vector& z) = 0;
  /// For the Hessian of the last prepare(), and until new_step(): does more in every apply(), where there is more that
  /// it could do. False if not.
  virtual bool strengthen() { return false; }
  /// What was done since the last call, the assembly of particles left out.
  SolverWork take_work() { return std::exchange(work_, {}); }
  /// The step's nodes have changed: forget what depends on them.
  virtual void new_step() {}

 protected:
  SolverWork work_;  ///< to be added to by prepare() and apply()
};

/// That of a solver by conjugate gradients; nullptr for other solvers.
template <int D>
std::unique_ptr<Preconditioner<D>> make_preconditioner(std::string_view solver, Parallel& parallel);

extern template std::unique_ptr<Preconditioner<2>> make_preconditioner<2>(std::string_view, Parallel&);
extern template std::unique_ptr<Preconditioner<3>> make_preconditioner<3>(std::string_view, Parallel&);

}  // namespace pf
