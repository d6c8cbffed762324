// One step: particles -> grid -> minimise -> particles (THEORY T3 to T5), and what happens when it does not work out.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "core/energies/ghost_stiffness.hpp"
#include "core/energies/volume_patches.hpp"
#include "core/step/balance.hpp"
#include "core/step/energy_ledger.hpp"
#include "core/step/simulation_of.hpp"
#include "core/step/step_recorder.hpp"

namespace pf {

namespace {

/// Adds the time since the last lap to a phase.
class Lap {
 public:
  void operator()(double& phase) {
    const auto now = std::chrono::steady_clock::now();
    phase += std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

/// Halvings of dt before a step is given up.
constexpr int most_retries = 12;
/// A step this much shorter than the one asked for leads nowhere: a run that has blown up would creep on for ever.
constexpr double shortest_part = 1e-9;
/// A particle that crosses this many cells in one step has run away.
constexpr double runaway_cells = 1000;

}  // namespace

template <int D>
const StepReport& SimulationOf<D>::step(const std::atomic<bool>* cancel) {
  const auto begin = std::chrono::steady_clock::now();
  returned_ = {};
  returned_.step = accepted_.step;
  returned_.time = time_;
  if (time_ >= end_ - 1e-9 * scene_.time.step) {
    returned_.status = StepStatus::finished;
    return returned_;
  }
  work_ = {};
  record_.reset();
  StepChoice choice = first_choice();
  for (int retry = 0, given_up = 0;;) {
    StepReport report;
    report.retries = retry;
    report.control.given_up = given_up;
    report.warnings = returned_.warnings;
    const Attempt attempt = this->attempt(choice, cancel, report);
    if (attempt.outcome == Attempt::accepted) {
      report.ms.total = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
      count_solves(report);
      accepted_ = std::move(report);
      return accepted_;
    }
    if (attempt.outcome == Attempt::inexact) {
      choice = attempt.instead;
      ++given_up;
      continue;
    }
    if (attempt.outcome == Attempt::cancelled) {
      control_->restore();
      returned_.status = StepStatus::cancelled;
      return returned_;
    }
    if (attempt.outcome == Attempt::refused) {
      control_->restore();
      returned_.status = StepStatus::failed;
      returned_.failure = attempt.reason;
      return returned_;
    }
    const StepChoice shorter = control_->retry(choice);
    if (retry == most_retries || shorter.dt < shortest_part * scene_.time.step) {
      control_->restore();
      returned_.status = StepStatus::failed;
      returned_.retries = retry;
      returned_.failure =
          attempt.reason + " Even a time step of " + number(choice.dt) +
          " s did not help. What may help: a smaller /time/step from the start, more particles a cell, a "
          "finer grid, a less extreme material or load.";
      return returned_;
    }
    choice = shorter;
    ++retry;
    returned_.warnings.push_back("Step " + std::to_string(accepted_.step + 1) + " at t = " + number(time_) +
                                 " s: " + attempt.reason + " Retried with dt = " + number(choice.dt) + " s.");
  }
}

template <int D>
void SimulationOf<D>::grid_velocity(double dt, StepReport& report) {
  particles_to_grid(plan_, particles_, transfer_->affine(), parallel_, grid_);
  lumped_velocity(plan_, particles_, grid_);
  prescribed_.clear();
  for (const NodeConstraint<D>& c : set_.constrained)
    if (!c.free.isIdentity(0)) prescribed_.push_back({c.node, c.free, c.given_velocity - dt * c.given_acceleration});
  sharpen(grid_.momentum, grid_.v, report);
  work_.p2g += particles_.size();
}

template <int D>
void SimulationOf<D>::sharpen(const Vector& momentum, Vector& rate, StepReport& report) {
  const bool consistent =
      scene_.transfer.velocity_mass == "consistent" && find_integrator(scene_.integrator.type)->inertia;
  if (transfer_->order() < 2 && !consistent) return;
  // FMPM takes back, order by order, what lumping does to M itself.
  const MassMatrix<D> M(plan_, particles_, grid_.mass, {true, consistent ? scene_.integrator.ghost_penalty : 0},
                        parallel_, work_, &velocity_mass_memory_);
  tell_of_blend(M, report);
  if (!consistent) return sharpen_velocity(M, transfer_->order(), rate, prescribed_);
  double residual = 0;
  M.solve(momentum, rate, residual);
  if (residual > 1e-8)
    report.warnings.push_back("The consistent velocity transfer left a relative residual of " + number(residual) + ".");
}

template <int D>
void SimulationOf<D>::grid_acceleration(bool carried, StepReport& report) {
  grid_.a.resize(0);
  grid_.a_end.resize(0);
  if (!carried || particles_.a.empty()) return;
  std::vector<Vec<D>> force(particles_.size());
  for (std::size_t p = 0; p < force.size(); ++p) force[p] = particles_.mass[p] * particles_.a[p];
  Vector sum = Vector::Zero(grid_.mass.size() * D);
  scatter_field<D>(plan_, force, parallel_, sum);
  grid_.a = sum;
  const double rounding = 1e-14 * grid_.mass.maxCoeff();
  for (Eigen::Index i = 0; i < grid_.mass.size(); ++i)
    grid_.a.template segment<D>(i * D) *= grid_.mass[i] > rounding ? 1 / grid_.mass[i] : 0;
  prescribed_.clear();
  for (const NodeConstraint<D>& c : set_.constrained)
    if (!c.free.isIdentity(0)) prescribed_.push_back({c.node, c.free, c.given_acceleration});
  sharpen(sum, grid_.a, report);
}

template <int D>
void SimulationOf<D>::carry_acceleration() {
  if (grid_.a_end.size() == 0) return;
  std::vector<Vec<D>> gained(particles_.size());
  gather_field<D>(plan_, particles_.a.empty() ? grid_.a_end : Vector(grid_.a_end - grid_.a), parallel_, gained);
  if (particles_.a.empty()) particles_.a.assign(particles_.size(), Vec<D>::Zero());
  for (std::size_t p = 0; p < gained.size(); ++p) particles_.a[p] += gained[p];
}

/// What the stages of one attempt ask for.
template <int D>
class SimulationOf<D>::Stages final : public StepConditions<D> {
 public:
  Stages(SimulationOf& simulation, double dt) : s_(simulation), dt_(dt) {}
  void force(double fraction, Vector& f) override {
    const double t = s_.time_ + fraction * dt_;
    s_.loads_.force(s_.plan_, s_.particles_, s_.grid_.mass, t, s_.parallel_, f);
    if (s_.known_.manufactured()) s_.known_.add_force(s_.plan_, s_.particles_, s_.laws_, s_.scene_, t, s_.parallel_, f);
    if (f.allFinite()) return;
    unfit = t;
    f.setZero();
  }
  FeasibleSet<D> set_of_part(double fraction) override {
    FeasibleSet<D> part = s_.conditions_.at(s_.plan_, s_.time_, fraction * dt_);
    s_.guess_friction(part);
    return part;
  }
  double unfit = NAN;  ///< when a force was not a finite number [s]

 private:
  SimulationOf& s_;
  double dt_;
};

template <int D>
typename SimulationOf<D>::Attempt SimulationOf<D>::attempt(const StepChoice& choice, const std::atomic<bool>* cancel,
                                                           StepReport& report) {
  Lap lap;
  const double dt = choice.dt, work_before = weigh(work_);
  Integrator<D>& integrator = integrator_of(choice);
  FeasibleSet<D>& set = set_;
  conditions_.at(plan_, time_, dt, set);
  grid_velocity(dt, report);
  grid_acceleration(integrator.carries_acceleration(), report);
  lap(report.ms.transfer);
  guess_friction(set);
  if (!has_inertia(choice))
    if (const std::string loose = free_rigid_motion(plan_, set); !loose.empty()) return {Attempt::refused, loose};
  Stages stages(*this, dt);
  if (!grid_.v.allFinite()) stages.unfit = time_;
  const MassMatrix<D> M(plan_, particles_, grid_.mass, inertia_mass(), parallel_, work_, &mass_memory_);
  if (M.consistent()) tell_of_blend(M, report);
  ElasticEnergy<D> elastic(plan_, particles_, laws_, parallel_, work_, &elastic_memory_);
  std::optional<GrabSpring<D>> spring;
  if (grab_) spring.emplace(plan_, particles_, held_, Vec<D>(grab_->to.head<D>()), grab_stiffness_);
  std::optional<GhostStiffness<D>> ties;
  if (tie_light_nodes(choice)) ties.emplace(light_nodes_);
  const bool adaptive = control_->adaptive();
  if (!linear_ || choice.implicit) choose_solver(adaptive ? dt : scene_.time.step);
  linear_->new_step();
  lap(report.ms.assemble);
  const NewtonSettings newton{scene_.solver.newton_tolerance, scene_.solver.max_newton, scene_.solver.line_search};
  StepOutcome outcome{.choice = choice};
  std::optional<StepRecorder<D>> recorder;
  if (recording_ != RecordLevel::none) {
    recorder.emplace(recording_, plan_, particles_, laws_, grid_, inertia_mass(), parallel_);
    Stages apart(*this, dt);  // a load that is no number at t^n is not the step's trouble
    recorder->begin_step(accepted_.step + 1, time_, dt, apart);
  }
  const StepProblem<D> problem{plan_,
                               M,
                               elastic,
                               spring ? &*spring : nullptr,
                               set,
                               stages,
                               dt,
                               newton,
                               *linear_,
                               parallel_,
                               cancel,
                               grid_,
                               choice.kick,
                               adaptive ? &outcome.error_rate : nullptr,
                               recorder ? &*recorder : nullptr,
                               ties ? &*ties : nullptr};
  StepResult result = integrator.advance(problem);
  NewtonResult& solved = result.newton;
  if (recorder) record_ = recorder->solved(solved.iterations);
  const SolverWork solver_work = linear_->take_work();
  work_.solver_operations += solver_work.operations;
  work_.stencil_operations += solver_work.stencil_operations;
  lap(report.ms.linear_solve);
  if (solved.status == NewtonStatus::cancelled) return {Attempt::cancelled, ""};
  if (!std::isnan(stages.unfit))
    return {Attempt::failed, "A load, a body force or a particle's velocity is not a finite number at t = " +
                                 number(stages.unfit) + " s: look at the expressions of the scene."};
  outcome.error_rate /= size_;
  outcome.newton = static_cast<int>(solved.iterations.size());
  outcome.work = weigh(work_) - work_before;
  if (solved.status == NewtonStatus::converged)
    if (const auto instead = control_->judge(outcome, time_, end_, report.control.given_up))
      return {Attempt::inexact, "", *instead};
  // Angular momentum by cause: what the two transfers change, and what the step on the grid does (THEORY T6).
  Vector &before = momentum_before_, &after = momentum_after_;
  M.multiply(grid_.v, before);
  M.multiply(grid_.v_end, after);
  const Vec3 L_before = grid_angular_momentum(plan_, grid_.u, 0, before);
  const Vec3 L_after = grid_angular_momentum(plan_, grid_.u, 1, after);
  // Where forces act the inner ones have no torque.
  after -= before;
  if (result.impulses.empty())
    report.angular.outside = grid_angular_momentum(plan_, grid_.u, integrator.force_place(), after);
  for (const StageImpulse& stage : result.impulses)
    report.angular.outside += grid_angular_momentum(plan_, stage.u, 1, stage.impulse);
  report.angular.time_integration = L_after - L_before - report.angular.outside;
  GridEnergies energies;
  if (ledger_ && solved.status == NewtonStatus::converged) {
    // Counted work decides things; what is looked at must not.
    const Work counted = work_;
    energies = grid_energies<D>({problem, integrator, result, loads_.gravity(), before, after, has_inertia(choice)});
    work_ = counted;
  }
  report.grab_force = spring ? spring->force(grid_.u).norm() : 0;
  lap(report.ms.diagnostics);

  const Attempt verdict = judge(solved, choice, report);
  if (verdict.outcome != Attempt::accepted) return verdict;
  if (recorder) recorder->moved(moved_);
  lap(report.ms.update);
  loads_.surface().move(plan_, grid_.u);
  known_.surface().move(plan_, grid_.u);
  conditions_.advance(time_, dt);
  time_ += dt;
  const double nearest = std::round(time_ / scene_.time.step) * scene_.time.step;
  if (!adaptive && std::abs(time_ - nearest) < 1e-9 * scene_.time.step) time_ = nearest;
  if (std::abs(time_ - end_) < 1e-9 * scene_.time.step) time_ = end_;
  report.dt = dt;
  report.step = accepted_.step + 1;
  report.newton = std::move(solved.iterations);
  report.residual = solved.residual;
  report.linear_iterations = solved.linear_iterations;
  report.active_nodes = plan_.node_count();
  keep_grid(set);
  keep_friction(set);
  carry_acceleration();
  plan_.follow(particles_, moved_, parallel_);
  tell_of_plan(report);
  lap(report.ms.sort);
  if (!choice.implicit) elastic.find_rest();
  lap(report.ms.linear_solve);
  fill_diagnostics(report);
  report.angular.transfer =
      (L_before - accepted_.balance.angular_momentum) + (report.balance.angular_momentum - L_after);
  // Velocities that are only reported have no momentum that transfers or the time scheme could lose.
  if (!has_inertia(choice))
    report.angular = {.outside = report.balance.angular_momentum - accepted_.balance.angular_momentum};
  report.angular.strokes = stroked_angular_;
  if (ledger_) {
    report.energy = close_ledger(energies, accepted_.balance, report.balance, has_inertia(choice), edited_energy_);
    report.energy.strokes = stroked_energy_;
  }
  edited_energy_ = stroked_energy_ = 0;
  stroked_angular_.setZero();
  report.work = work_;
  tell_control(outcome, report);
  lap(report.ms.diagnostics);
  return {};
}

template <int D>
typename SimulationOf<D>::Attempt SimulationOf<D>::judge(const NewtonResult& newton, const StepChoice& choice,
                                                         StepReport& report) {
  if (newton.status != NewtonStatus::converged) {
    const std::string at =
        " (residual " + number(newton.residual) + ", tolerance " + number(scene_.solver.newton_tolerance) + ").";
    switch (newton.status) {
      case NewtonStatus::not_converged:
        return {Attempt::failed, "Newton's method did not converge within " + std::to_string(scene_.solver.max_newton) +
                                     " iterations" + at};
      case NewtonStatus::infeasible_start:
        return {Attempt::failed, "A prescribed displacement turns material inside out within one step."};
      case NewtonStatus::not_finite:
        return {Attempt::failed, scene_.solver.line_search
                                     ? "The residual is not a finite number."
                                     : "A whole step of Newton's method led to where the energy has no value."};
      default:
        return {Attempt::failed, "The line search found no lower energy" + at};
    }
  }
  if (!grid_.u.allFinite() || !grid_.v_end.allFinite()) return {Attempt::failed, "The grid's motion is not finite."};
  // Tangents have served: their memory takes the particles' new state. Where there were none there is a memory to
  // exchange.
  moved_ = choice.implicit ? apart<D>(particles_.size(), transfer_->affine(), elastic_memory_.tangents)
                           : exchanged<D>(particles_, transfer_->affine(), other_);
  if (!plan_.foresee(particles_, grid_.u, moved_, parallel_))
    return {Attempt::failed, "Particles are too far apart for a grid to be laid, or have a place that is not finite."};
  const StateCheck check = transfer_->grid_to_particles(plan_, grid_, particles_, parallel_, moved_);
  work_.g2p += particles_.size();
  const auto who = [&] { return "Particle " + std::to_string(worst_particle(particles_, moved_)); };
  if (!check.finite) return {Attempt::failed, who() + " has a value that is not finite."};
  if (!(check.min_J > 0)) return {Attempt::failed, who() + " was turned inside out (J = " + number(check.min_J) + ")."};
  report.min_J = check.min_J;
  report.max_J = check.max_J;
  if (any_shares_volume(laws_))
    std::tie(report.min_J, report.max_J) = share_volumes(plan_, particles_, laws_, parallel_, moved_);
  report.cfl = check.max_speed * choice.dt / scene_.grid.spacing;
  if (report.cfl > runaway_cells)
    return {Attempt::failed,
            "A particle runs away: " + number(check.max_speed) + " m/s, " + number(report.cfl) + " cells in one step."};
  return {};
}

template <int D>
void SimulationOf<D>::fill_diagnostics(StepReport& report) const {
  report.time = time_;
  report.strokes = strokes_;
  const bool known_energy = elastic_memory_.rest_plan == plan_.made();
  report.balance = particle_balance<D>(particles_, laws_, plan_, transfer_->affine(), loads_.gravity(), parallel_,
                                       known_energy ? &elastic_memory_.rest_energy : nullptr);
  if (!find_integrator(scene_.integrator.type)->inertia) report.balance.kinetic = 0;
  if (report.step == 0) report.active_nodes = plan_.node_count();
  if (known_.known()) report.error = known_.errors(particles_, time_, parallel_);
}

template <int D>
void SimulationOf<D>::describe_state(StepReport& report) {
  const StateCheck check = check_state(particles_);
  report.min_J = check.min_J;
  report.max_J = check.max_J;
  // As an explicit step would have found it: a run that is taken up again tells the same energy to the last bit.
  if (!find_integrator(scene_.integrator.type)->implicit)
    ElasticEnergy<D>(plan_, particles_, laws_, parallel_, work_, &elastic_memory_).find_rest();
  fill_diagnostics(report);
}

template class SimulationOf<2>;
template class SimulationOf<3>;

}  // namespace pf
