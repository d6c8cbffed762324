// Newton's method with line search for min E(u) over a feasible set (THEORY T4, T7).
#pragma once

#include "core/solvers/linear_solver.hpp"
#include "core/solvers/newton_observer.hpp"
#include "core/step_report.hpp"

namespace pf {

struct NewtonSettings {
  double tolerance = 1e-6;  ///< of THEORY T4
  int max_iterations = 50;
  bool line_search = true;  ///< off: full steps, which may lead anywhere; E must stay finite
};

enum class NewtonStatus { converged, cancelled, not_converged, line_search_failed, infeasible_start, not_finite };

struct NewtonResult {
  NewtonStatus status = NewtonStatus::converged;
  double residual = 0;  ///< relative, T4
  int linear_iterations = 0;
  std::vector<NewtonIteration> iterations;  ///< one entry an evaluated iterate, the last without a step
};

/// What a minimisation computes with; kept between solves for its memory alone.
template <int D>
struct NewtonVectors {
  Vector g, free_g, d, trial, trial_g, held, model_g, natural_g;
  Vector tau;  ///< of FeasibleSet::natural_residual; empty until it is needed
  Vector start, start_g;
  ActiveSet<D> active, start_active;
  std::vector<Mat<D>> blocks;
  std::vector<char> marked;
};

/// The true Hessian is tried first; where it is not positive definite along the way, it is projected at the nodes with
/// the largest residuals, then at more, then everywhere (Fernandez-Fernandez et al. 2025, Progressively Projected
/// Newton's Method, arXiv 2505.21013); since a neighbourhood of indefinite points is seldom left at once, it stays so
/// for the rest of the solve until the residual has fallen by two orders. The step is searched along the projected path
/// P(u + alpha d), E never rises; where differences of E are lost in rounding the gradient's norm decides instead. On
/// failure u is the best iterate so far. `vectors`, where they are given, lend their memory; `observer`, where there is
/// one, looks on.
template <int D>
NewtonResult minimise(Objective<D>& objective, const FeasibleSet<D>& set, LinearSolver<D>& linear,
                      const NewtonSettings& settings, const std::atomic<bool>* cancel, Vector& u,
                      NewtonVectors<D>* vectors = nullptr, NewtonObserver* observer = nullptr);

extern template NewtonResult minimise<2>(Objective<2>&, const FeasibleSet<2>&, LinearSolver<2>&, const NewtonSettings&,
                                         const std::atomic<bool>*, Vector&, NewtonVectors<2>*, NewtonObserver*);
extern template NewtonResult minimise<3>(Objective<3>&, const FeasibleSet<3>&, LinearSolver<3>&, const NewtonSettings&,
                                         const std::atomic<bool>*, Vector&, NewtonVectors<3>*, NewtonObserver*);

}  // namespace pf
