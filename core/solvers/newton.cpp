#include "core/solvers/newton.hpp"

#include <algorithm>
#include <cmath>

namespace pf {

namespace {

/// The state of one solve: an iterate with its energy, gradient and free directions.
template <int D>
class Minimiser {
 public:
  Minimiser(Objective<D>& objective, const FeasibleSet<D>& set, LinearSolver<D>& linear, const NewtonSettings& settings,
            const std::atomic<bool>* cancel, Vector& u, NewtonVectors<D>& vectors, NewtonObserver* observer)
      : objective_(objective),
        set_(set),
        linear_(linear),
        settings_(settings),
        cancel_(cancel),
        u_(u),
        vectors_(vectors),
        observer_(observer) {}

  NewtonResult run();

 private:
  bool cancelled() const { return cancel_ && cancel_->load(std::memory_order_relaxed); }
  /// E and g at u, and what of g the constraints leave: its size is the residual.
  void evaluate();
  void reduce();
  bool one_sided() const;
  void mind_rounding();
  void measure_stiffness();
  double forcing() const;
  Projected projected() const;
  double projected_share() const;
  void project_more(int round);
  LinearResult solve_for_direction(NewtonIteration& record);
  LinearResult meet_faces(NewtonIteration& record);
  void take_diagonal_step();
  bool search(NewtonIteration& record);
  bool search_energy(NewtonIteration& record, double slope);
  bool search_residual(NewtonIteration& record);
  bool take_whole_step(NewtonIteration& record);
  NewtonResult finish(NewtonStatus status) {
    result_.status = status;
    result_.residual = residual_;
    return std::move(result_);
  }

  Objective<D>& objective_;
  const FeasibleSet<D>& set_;
  LinearSolver<D>& linear_;
  const NewtonSettings& settings_;
  const std::atomic<bool>* cancel_;
  Vector& u_;
  NewtonVectors<D>& vectors_;
  NewtonObserver* const observer_;
  Vector &g_ = vectors_.g, &free_g_ = vectors_.free_g, &d_ = vectors_.d, &trial_ = vectors_.trial;
  Vector &trial_g_ = vectors_.trial_g, &held_ = vectors_.held, &model_g_ = vectors_.model_g;
  Vector &natural_g_ = vectors_.natural_g, &tau_ = vectors_.tau;
  ActiveSet<D>& active_ = vectors_.active;
  std::vector<Mat<D>>& blocks_ = vectors_.blocks;
  bool have_tau_ = false;
  bool unsettled_ = false;  ///< the last step met faces that were not active
  double E_ = 0, residual_ = 0, norm_ = 0, previous_norm_ = 0;
  enum class Where { nowhere, marked, everywhere };
  Where project_ = Where::nowhere;
  std::vector<char>& marked_ = vectors_.marked;
  double norm_when_projected_ = 0;
  double rounding_ = 0;  ///< of g, where it has been asked for
  NewtonResult result_;
};

template <int D>
void Minimiser<D>::reduce() {
  free_g_ = g_;
  set_.active_set(u_, free_g_, active_);
  if (!have_tau_) {
    norm_ = objective_.norm(free_g_);
  } else {
    natural_g_ = free_g_;
    set_.natural_residual(u_, g_, tau_, natural_g_);
    norm_ = objective_.norm(natural_g_);
  }
  // A problem without any force is solved where it stands.
  const double scale = objective_.scale();
  residual_ = norm_ == 0 ? 0 : norm_ / std::max(scale, 1e-300);
  if (rounding_ > 0) residual_ = std::min(residual_, settings_.tolerance * norm_ / rounding_);
}

template <int D>
void Minimiser<D>::evaluate() {
  E_ = objective_.gradient(u_, g_);
  reduce();
}

template <int D>
bool Minimiser<D>::one_sided() const {
  return std::any_of(set_.constrained.begin(), set_.constrained.end(),
                     [](const NodeConstraint<D>& c) { return c.faces > 0 || c.rub_bound > 0; });
}

/// Of bodies that have all but come to rest what is left of g is rounding, at which no step gets further: forces that
/// T4 compares with have gone too. From now on that counts as converged.
template <int D>
void Minimiser<D>::mind_rounding() {
  if (rounding_ > 0) return;
  rounding_ = objective_.rounding();
  reduce();
}

template <int D>
void Minimiser<D>::measure_stiffness() {
  blocks_.assign(static_cast<std::size_t>(u_.size() / D), Mat<D>::Zero());
  objective_.diagonal(blocks_);
  have_tau_ = true;
  tau_.resize(u_.size() / D);
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const double stiffness = blocks_[i].trace() / D;
    tau_[static_cast<Eigen::Index>(i)] = stiffness > 0 ? 1 / stiffness : 0;
  }
}

template <int D>
double Minimiser<D>::forcing() const {
  // Eisenstat and Walker 1996, choice 2, never tighter than the tolerance needs. While faces come and go a solve is
  // good for one set of them only.
  const double most = unsettled_ ? 0.3 : 0.1;
  double eta = most;
  if (previous_norm_ > 0) eta = std::min(eta, 0.9 * (norm_ / previous_norm_) * (norm_ / previous_norm_));
  const double needed = 0.1 * settings_.tolerance / std::max(residual_, 1e-300);
  return std::clamp(std::max(eta, needed), 1e-10, most);
}

template <int D>
Projected Minimiser<D>::projected() const {
  if (project_ == Where::marked) return Projected(marked_);
  return project_ == Where::everywhere;
}

template <int D>
double Minimiser<D>::projected_share() const {
  if (project_ != Where::marked) return project_ == Where::everywhere ? 1 : 0;
  return static_cast<double>(std::count(marked_.begin(), marked_.end(), 1)) / static_cast<double>(marked_.size());
}

/// The nodes with the largest residuals first: what is far from its balance is where the Hessian is indefinite
/// (Fernandez-Fernandez et al. 2025). Each round asks for a tenth of the size.
template <int D>
void Minimiser<D>::project_more(int round) {
  constexpr int most_rounds = 2;
  norm_when_projected_ = norm_;
  const Eigen::Index nodes = free_g_.size() / D;
  if (project_ == Where::nowhere) marked_.assign(static_cast<std::size_t>(nodes), 0);
  project_ = round > most_rounds ? Where::everywhere : Where::marked;
  if (project_ == Where::everywhere) return;
  const auto square = [&](Eigen::Index i) { return free_g_.template segment<D>(i * D).squaredNorm(); };
  double largest = 0;
  for (Eigen::Index i = 0; i < nodes; ++i) largest = std::max(largest, square(i));
  const double least = largest * (round == 1 ? 1e-2 : 1e-4);
  for (Eigen::Index i = 0; i < nodes; ++i)
    if (square(i) >= least) marked_[static_cast<std::size_t>(i)] = 1;
}

template <int D>
LinearResult Minimiser<D>::solve_for_direction(NewtonIteration& record) {
  if (norm_ < 1e-2 * norm_when_projected_) project_ = Where::nowhere;
  for (int round = 1;; ++round) {
    objective_.prepare_hessian(u_, projected());
    if (!have_tau_ && one_sided()) measure_stiffness();
    const LinearProblem<D> problem{objective_, set_, active_.directions, free_g_, forcing(), cancel_};
    LinearResult solved = linear_.solve(problem, d_);
    record.linear_iterations += solved.iterations;
    record.projected = projected_share();
    result_.linear_iterations += solved.iterations;
    unsettled_ = !solved.cancelled && !solved.negative_curvature && set_.crosses(u_, g_, d_, active_);
    if (unsettled_) solved = meet_faces(record);
    if (solved.cancelled || !solved.negative_curvature || project_ == Where::everywhere) return solved;
    reduce();
    project_more(round);
  }
}

/// d_ becomes the minimiser of the quadratic model over the set, found by a primal-dual active set method, or at least
/// a feasible step on which E falls.
template <int D>
LinearResult Minimiser<D>::meet_faces(NewtonIteration& record) {
  constexpr int most = 12;
  double accuracy = 0.3;  // of a round's solve, relative to that of a plain Newton step: signs of reactions hang on it
  LinearResult solved;
  for (int round = 0; round < most; ++round) {
    model_g_.setZero(d_.size());
    objective_.hessian_product(d_, model_g_);
    const double curvature = d_.dot(model_g_);
    solved.negative_curvature = !(curvature > 0);
    if (solved.negative_curvature) return solved;
    model_g_ += g_;
    const bool changed = set_.update_active(u_, g_, d_, model_g_, d_.squaredNorm() / curvature, active_, held_);
    if (!changed && round > 0 && set_.slope(u_, g_, d_) < 0) break;
    // Go on from what the new active set leaves of the last step: d = held + Q d_last + correction.
    set_.restrict_to(active_.directions, d_);
    held_ += d_;
    model_g_.setZero(d_.size());
    objective_.hessian_product(held_, model_g_);
    model_g_ += g_;
    set_.restrict_to(active_.directions, model_g_);
    const double left = objective_.norm(model_g_);
    const double tolerance = accuracy * forcing() * objective_.norm(free_g_) / std::max(left, 1e-300);
    LinearProblem<D> problem{objective_, set_, active_.directions, model_g_, std::min(0.5, tolerance), cancel_};
    problem.same_hessian = true;
    solved = linear_.solve(problem, d_);
    record.linear_iterations += solved.iterations;
    result_.linear_iterations += solved.iterations;
    if (solved.cancelled || solved.negative_curvature) return solved;
    d_ += held_;
    const bool falls = set_.slope(u_, g_, d_) < 0;
    if (falls && !set_.crosses(u_, g_, d_, active_)) break;
    if (!falls) accuracy *= 0.1;
  }
  trial_ = u_ + d_;
  set_.project_from(u_, g_, active_, trial_);
  d_ = trial_ - u_;
  return solved;
}

/// The step of Jacobi's projected method: crude, but E falls along it unless u is the minimum.
template <int D>
void Minimiser<D>::take_diagonal_step() {
  if (!have_tau_) measure_stiffness();
  d_.resize(u_.size());
  for (Eigen::Index i = 0; i < tau_.size(); ++i)
    d_.segment<D>(i * D) = -0.5 * tau_[i] * free_g_.template segment<D>(i * D);
  trial_ = u_ + d_;
  set_.project_from(u_, g_, active_, trial_);
  d_ = trial_ - u_;
}

template <int D>
bool Minimiser<D>::search_energy(NewtonIteration& record, double slope) {
  constexpr double sufficient = 1e-4;
  double alpha = 1;
  for (int k = 0; k < 30; ++k, alpha *= 0.5) {
    trial_ = u_ + alpha * d_;
    set_.project_from(u_, g_, active_, trial_);
    // The full step is nearly always taken, and then its gradient is needed next.
    const double E = k == 0 ? objective_.gradient(trial_, trial_g_) : objective_.value(trial_);
    if (std::isfinite(E) && E <= E_ + sufficient * alpha * slope) {
      record.step_length = alpha;
      u_.swap(trial_);
      if (k == 0) {
        E_ = E;
        g_.swap(trial_g_);
      } else {
        E_ = objective_.gradient(u_, g_);
      }
      return true;
    }
    if (alpha * std::abs(slope) < 1e-15 * objective_.energy_scale()) break;
  }
  return false;
}

template <int D>
bool Minimiser<D>::search_residual(NewtonIteration& record) {
  const double before = norm_;
  Vector &start = vectors_.start, &start_g = vectors_.start_g;
  start = u_;
  start_g = g_;
  ActiveSet<D>& active = vectors_.start_active;
  active = active_;
  const double start_E = E_;
  double alpha = 1;
  for (int k = 0; k < 8; ++k, alpha *= 0.5) {
    u_ = start + alpha * d_;
    set_.project_from(start, start_g, active, u_);
    E_ = objective_.gradient(u_, g_);
    const double rounding = 1e-12 * std::max(objective_.energy_scale(), std::abs(start_E));
    if (!std::isfinite(E_) || E_ > start_E + rounding) continue;
    reduce();
    if (norm_ < before) {
      record.step_length = alpha;
      record.residual_search = true;
      return true;
    }
  }
  u_ = start;
  g_ = start_g;
  E_ = start_E;
  reduce();
  return false;
}

/// Newton's method as it stands in textbooks. False: E ends before the step does, there is nothing to go on from.
template <int D>
bool Minimiser<D>::take_whole_step(NewtonIteration& record) {
  trial_ = u_ + d_;
  set_.project_from(u_, g_, active_, trial_);
  record.step_length = 1;
  const double E = objective_.gradient(trial_, trial_g_);
  if (!std::isfinite(E)) return false;
  E_ = E;
  u_.swap(trial_);
  g_.swap(trial_g_);
  return true;
}

template <int D>
bool Minimiser<D>::search(NewtonIteration& record) {
  if (!settings_.line_search) return take_whole_step(record);
  const double slope = set_.slope(u_, g_, d_);
  if (!(slope < 0) || !d_.allFinite()) return false;
  const bool visible = -slope > 1e-13 * objective_.energy_scale();
  if (visible && search_energy(record, slope)) return true;
  return search_residual(record);
}

template <int D>
NewtonResult Minimiser<D>::run() {
  result_.iterations.reserve(8);
  set_.project(u_);
  evaluate();
  if (observer_) observer_->begin();
  if (!std::isfinite(E_)) return finish(NewtonStatus::infeasible_start);
  for (int k = 0;; ++k) {
    NewtonIteration record;
    record.residual = residual_;
    record.energy = E_;
    if (observer_) observer_->iterate(u_, have_tau_ ? natural_g_ : free_g_, record);
    if (!std::isfinite(residual_)) return finish(NewtonStatus::not_finite);
    const bool stalls = k > 2 && norm_ > 0.3 * previous_norm_;
    if (residual_ > settings_.tolerance && stalls) {
      mind_rounding();
      record.residual = residual_;
    }
    if (residual_ <= settings_.tolerance) {
      result_.iterations.push_back(record);
      return finish(NewtonStatus::converged);
    }
    if (k == settings_.max_iterations) {
      result_.iterations.push_back(record);
      return finish(NewtonStatus::not_converged);
    }
    if (cancelled()) return finish(NewtonStatus::cancelled);
    const LinearResult solved = solve_for_direction(record);
    if (solved.cancelled) return finish(NewtonStatus::cancelled);
    if (solved.negative_curvature) d_ = -free_g_;  // only rounding makes a projected Hessian indefinite
    previous_norm_ = norm_;
    bool moved = search(record);
    if (!moved && !settings_.line_search) {
      result_.iterations.push_back(record);
      return finish(NewtonStatus::not_finite);
    }
    if (!moved) {
      mind_rounding();
      if (residual_ <= settings_.tolerance) {
        result_.iterations.push_back(record);
        continue;
      }
      moved = search(record);  // with what it now takes for rounding of E
    }
    if (!moved && project_ != Where::everywhere) {
      // A true Hessian can point uphill far from the minimum: once more with the projected one.
      project_ = Where::everywhere;
      norm_when_projected_ = norm_;
      reduce();  // the refused step may have left its own active set
      const LinearResult again = solve_for_direction(record);
      if (again.cancelled) return finish(NewtonStatus::cancelled);
      moved = !again.negative_curvature && search(record);
    }
    if (!moved) {
      reduce();
      take_diagonal_step();
      moved = search(record);
    }
    result_.iterations.push_back(record);
    if (!moved) return finish(NewtonStatus::line_search_failed);
    reduce();
  }
}

}  // namespace

template <int D>
NewtonResult minimise(Objective<D>& objective, const FeasibleSet<D>& set, LinearSolver<D>& linear,
                      const NewtonSettings& settings, const std::atomic<bool>* cancel, Vector& u,
                      NewtonVectors<D>* vectors, NewtonObserver* observer) {
  NewtonVectors<D> own;
  return Minimiser<D>(objective, set, linear, settings, cancel, u, vectors ? *vectors : own, observer).run();
}

template NewtonResult minimise<2>(Objective<2>&, const FeasibleSet<2>&, LinearSolver<2>&, const NewtonSettings&,
                                  const std::atomic<bool>*, Vector&, NewtonVectors<2>*, NewtonObserver*);
template NewtonResult minimise<3>(Objective<3>&, const FeasibleSet<3>&, LinearSolver<3>&, const NewtonSettings&,
                                  const std::atomic<bool>*, Vector&, NewtonVectors<3>*, NewtonObserver*);

}  // namespace pf
