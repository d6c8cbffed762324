#include "core/control/adaptive_control.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace pf {

namespace {

/// Steps aim at this share of the tolerance; one is taken up to `accepted` times the tolerance.
constexpr double aim = 0.9, still_accepted = 2;
constexpr int most_given_up = 8;
/// Memory of the running mean of errors, a step: about ten steps. A longer one does not follow the motion, a shorter
/// one lets dt swing with every swing of the body, and a swinging dt costs more than a steady one.
constexpr double memory = 0.9;
/// The same of explicit steps, from mark to mark: leapfrog loses its second order where dt swings.
constexpr double jerk_memory = 0.98;
constexpr double usual_growth = 1.5, careful_growth = 1.1;
/// dt stays as it is within these bounds of what it should be.
constexpr double hold_below = 0.95, hold_above = 1.15;
/// More iterations than this and a longer step is no cheaper.
constexpr int many_newton = 15;
/// Steps between two looks at the explicit limit.
constexpr double limit_interval = 16;
/// A change of integrator must promise this much, so often in a row, and not before so many steps. A first implicit
/// step must promise more: nothing is known of its error, and one that is given up costs as much as many explicit ones.
constexpr double explicit_pays = 0.9, implicit_pays = 0.75, first_pays = 0.5;
constexpr double votes_needed = 2, first_patience = 16, most_patience = 4096;
/// Explicit steps between two marks of the motion, at first and at least later.
constexpr double first_steps_a_mark = 2, steps_a_mark = 8;
/// Newton iterations of a usual step, and conjugate-gradient iterations for each cell that a wave crosses in it
/// (docs/performance.md): a first guess, which counting corrects.
constexpr double usual_newton = 3, iterations_a_cell = 2.6;

double or_else(double value, double otherwise) {
  return value > 0 ? value : otherwise;
}

}  // namespace

AdaptiveControl::AdaptiveControl(const ControlSetup& setup) : setup_(setup), marks_(setup.dimension) {
  now_.dt_implicit = now_.implicit_target = setup.step;
  now_.growth = usual_growth;
  now_.patience = first_patience;
  now_.age = limit_interval;
  kept_ = now_;
}

bool AdaptiveControl::wants_limit() const {
  return may_be_explicit() && now_.age >= limit_interval;
}

void AdaptiveControl::tell_limit(double limit) {
  now_.limit = limit;
  now_.age = 0;
  // Equal steps are the most exact: only what is worth it.
  if (now_.dt_stable == 0 || limit < now_.dt_stable || limit > 1.05 * now_.dt_stable) now_.dt_stable = limit;
}

void AdaptiveControl::allow_explicit(bool allowed) {
  now_.barred = allowed ? 0 : 1;
  if (!allowed && now_.implicit == 0) go_implicit(std::max(now_.dt_implicit, explicit_step()));
}

double AdaptiveControl::implicit_work(double dt) const {
  const double cells = setup_.wave_speed * dt / setup_.spacing, across = setup_.size / setup_.spacing;
  const double iterations = std::max(2.0, iterations_a_cell * std::min(cells, across));
  return setup_.implicit_work + usual_newton * (setup_.newton_work + iterations * setup_.linear_work);
}

double AdaptiveControl::implicit_cost() const {
  const double dt = std::min({now_.implicit_target, setup_.largest, 4 * now_.dt_implicit});
  return now_.work_ratio * implicit_work(dt) / dt;
}

double AdaptiveControl::explicit_step() const {
  double dt = std::min(now_.dt_stable, setup_.largest);
  dt = std::min(dt, or_else(now_.dt_exact, dt));
  return std::min(dt, or_else(now_.dt_mended, dt));
}

double AdaptiveControl::explicit_cost() const {
  return (setup_.explicit_work + setup_.limit_work / limit_interval) / explicit_step();
}

void AdaptiveControl::go_explicit() {
  now_.implicit = 0;
  now_.votes = now_.since = 0;
  now_.next_mark = now_.time;
  now_.dt_exact = now_.behind = now_.jerk = 0;
  now_.mark_interval = 0;
  marks_.clear();
}

void AdaptiveControl::go_implicit(double dt) {
  now_.implicit = 1;
  now_.votes = now_.since = 0;
  now_.dt_implicit = now_.implicit_target = dt;
  now_.mean_square = 0;
  now_.newton_bound = 0;
  marks_.clear();
}

StepChoice AdaptiveControl::next(double time, double end) {
  now_.time = time;
  if (now_.begun == 0) {
    now_.begun = 1;
    if (may_be_explicit() && (explicit_step() >= setup_.step || first_pays * explicit_cost() < implicit_cost()))
      go_explicit();
  }
  StepChoice choice;
  choice.implicit = now_.implicit != 0;
  if (choice.implicit) {
    choice.dt = now_.dt_implicit;
    choice.limited_by = now_.newton_bound != 0                          ? StepLimit::newton
                        : now_.implicit_target > hold_above * choice.dt ? StepLimit::growth
                                                                        : StepLimit::tolerance;
  } else {
    choice.dt = explicit_step();
    choice.limited_by = choice.dt == now_.dt_exact    ? StepLimit::tolerance
                        : choice.dt == now_.dt_mended ? StepLimit::failure
                                                      : StepLimit::stability;
  }
  if (setup_.largest <= choice.dt) choice.dt = setup_.largest, choice.limited_by = StepLimit::largest;
  if (now_.speed * choice.dt > setup_.spacing) {
    choice.dt = setup_.spacing / now_.speed;
    choice.limited_by = StepLimit::crossing;
  }
  // The last few steps share what is left evenly; none is a tenth longer than it should be.
  const double left = end - time, steps = std::max(1.0, std::ceil(left / choice.dt - 0.1));
  if (steps <= 8 && left / steps != choice.dt) {
    const double even = left / steps;
    if (even < hold_below * choice.dt || even > choice.dt) choice.limited_by = StepLimit::landing;
    choice.dt = even;
  }
  if (!choice.implicit) choice.kick = now_.behind + choice.dt / 2;
  return choice;
}

std::optional<StepChoice> AdaptiveControl::judge(const StepOutcome& tried, double time, double end, int given_up) {
  double rate = std::max(0.0, tried.error_rate - now_.floor);
  if (!tried.choice.implicit || !(rate > still_accepted * setup_.tolerance) || given_up >= most_given_up)
    return std::nullopt;
  // Where a constraint's nodes share a consistent mass with free ones, their velocities jump in every step, however
  // short. What does not fall with dt although every wave is resolved is no error of the time step.
  const bool resolved = setup_.wave_speed * tried.choice.dt < 0.5 * setup_.spacing;
  if (resolved && given_up > 0 && tried.choice.dt < now_.refused_dt && rate > 0.8 * now_.refused_rate) {
    // What a straight line through both attempts leaves at dt = 0.
    const double d1 = now_.refused_dt, d2 = tried.choice.dt;
    const double part = std::clamp((rate * d1 - now_.refused_rate * d2) / (d1 - d2), 0.0, rate);
    now_.floor += part;
    rate -= part;
    if (!(rate > still_accepted * setup_.tolerance)) return std::nullopt;
  }
  now_.refused_dt = tried.choice.dt;
  now_.refused_rate = rate;
  learn_work(tried);
  now_.dt_implicit = now_.implicit_target = tried.choice.dt * std::clamp(aim * setup_.tolerance / rate, 0.1, 0.7);
  now_.mean_square = 0;
  if (may_be_explicit() && explicit_cost() < implicit_cost()) go_explicit();
  return next(time, end);
}

StepChoice AdaptiveControl::retry(const StepChoice& failed) {
  StepChoice again{failed.dt / 2, failed.implicit, StepLimit::failure};
  if (!again.implicit) again.kick = now_.behind + again.dt / 2;
  if (failed.implicit) {
    now_.dt_implicit = now_.implicit_target = again.dt;
    now_.mean_square = 0;
    now_.growth = careful_growth;
  } else {
    now_.dt_mended = again.dt;
    now_.age = limit_interval;
  }
  return again;
}

void AdaptiveControl::learn_work(const StepOutcome& outcome) {
  const double ratio = outcome.work / implicit_work(outcome.choice.dt);
  now_.work_ratio = now_.counted == 0 ? ratio : 0.7 * now_.work_ratio + 0.3 * ratio;
  now_.counted = 1;
}

void AdaptiveControl::accepted_implicit(const StepOutcome& outcome) {
  const double dt = outcome.choice.dt, per_dt = std::max(0.0, outcome.error_rate - now_.floor) / dt;
  now_.error_rate = outcome.error_rate;
  now_.floor *= 0.99;
  learn_work(outcome);
  now_.mean_square =
      now_.mean_square == 0 ? per_dt * per_dt : memory * now_.mean_square + (1 - memory) * per_dt * per_dt;
  double target = aim * setup_.tolerance / std::max(std::sqrt(now_.mean_square), 1e-300);
  now_.newton_bound = outcome.newton > many_newton && 0.8 * dt < target ? 1 : 0;
  if (now_.newton_bound != 0) target = 0.8 * dt;
  now_.implicit_target = target;
  // What a landing or a crossing cut short says nothing against the usual length.
  const double usual = std::max(dt, outcome.choice.limited_by == StepLimit::landing ? now_.dt_implicit : dt);
  if (target < hold_below * usual)
    now_.dt_implicit = std::max(target, 0.2 * usual);
  else if (target > hold_above * usual)
    now_.dt_implicit = std::min({target, now_.growth * usual, setup_.largest});
  now_.growth = std::min(usual_growth, now_.growth * 1.02);
  const bool cheaper = may_be_explicit() && now_.limit > 0 && explicit_cost() < explicit_pays * implicit_cost();
  now_.votes = cheaper ? now_.votes + 1 : 0;
  if (now_.votes >= votes_needed) {
    // Implicit steps that hardly began were a mistake: think longer before the next ones.
    if (now_.since < first_patience) now_.patience = std::min(most_patience, 2 * now_.patience);
    go_explicit();
  }
}

void AdaptiveControl::accepted_explicit(const StepOutcome& outcome) {
  now_.behind = outcome.choice.dt / 2;
  if (now_.dt_mended > 0) {
    now_.dt_mended *= 1.02;
    if (now_.dt_mended >= now_.dt_stable) now_.dt_mended = 0;
  }
}

void AdaptiveControl::accepted(const StepOutcome& outcome) {
  now_.time = outcome.time;
  now_.speed = outcome.speed;
  now_.age += 1;
  now_.since += 1;
  if (outcome.choice.implicit)
    accepted_implicit(outcome);
  else
    accepted_explicit(outcome);
}

bool AdaptiveControl::wants_positions() const {
  return now_.implicit == 0 && now_.time >= now_.next_mark;
}

void AdaptiveControl::tell_positions(double time, std::span<const double> x) {
  marks_.add(time, x);
  const double shortest = steps_a_mark * explicit_step();
  if (now_.mark_interval == 0) now_.mark_interval = first_steps_a_mark * explicit_step();
  now_.next_mark = time + now_.mark_interval;
  if (marks_.count() < 3) return;
  const double T = setup_.tolerance, dt = explicit_step();
  now_.jerk = std::max(marks_.jerk(), jerk_memory * now_.jerk);
  now_.error_rate = dt * dt / 24 * marks_.jerk();
  double exact = 0;
  if (now_.jerk > 0) exact = std::sqrt(24 * aim * T / now_.jerk);
  const double bound = or_else(now_.dt_exact, now_.dt_stable);
  if (exact >= now_.dt_stable)
    now_.dt_exact = 0;
  else if (exact > 0 && (exact < hold_below * bound || exact > hold_above * bound))
    now_.dt_exact = std::clamp(exact, 0.5 * bound, 2 * bound);
  // The first-order error that implicit steps would make of this motion: half a step times its acceleration.
  const double implicit_dt = std::min(2 * aim * T / std::max(marks_.acceleration(), 1e-300), setup_.largest);
  now_.mark_interval = std::min(std::max(implicit_dt / 2, shortest), 2 * now_.mark_interval);
  now_.next_mark = time + now_.mark_interval;
  now_.implicit_target = now_.dt_implicit = implicit_dt;
  const bool cheaper = now_.since >= now_.patience && implicit_cost() < implicit_pays * explicit_cost();
  now_.votes = cheaper ? now_.votes + 1 : 0;
  if (now_.votes >= votes_needed) go_implicit(implicit_dt);
}

void AdaptiveControl::report(ControlReport& report) const {
  report.adaptive = true;
  report.error_rate = now_.error_rate;
  report.explicit_limit = std::isfinite(now_.limit) ? now_.limit : 0;
  report.implicit_cost = implicit_cost();
  report.explicit_cost = may_be_explicit() && now_.limit > 0 ? explicit_cost() : 0;
}

std::vector<double> AdaptiveControl::state() const {
  const auto numbers = std::bit_cast<std::array<double, sizeof(State) / sizeof(double)>>(now_);
  std::vector<double> all(numbers.begin(), numbers.end());
  marks_.save(all);
  return all;
}

bool AdaptiveControl::set_state(std::span<const double> state) {
  std::array<double, sizeof(State) / sizeof(double)> numbers;
  if (state.size() < numbers.size()) return false;
  std::copy_n(state.begin(), numbers.size(), numbers.begin());
  std::span<const double> rest = state.subspan(numbers.size());
  MotionMarks marks(setup_.dimension);
  if (!marks.load(rest) || !rest.empty()) return false;
  now_ = kept_ = std::bit_cast<State>(numbers);
  marks_ = std::move(marks);
  return true;
}

}  // namespace pf
