// Adaptive step control on oscillators whose exact motion is known: what is promised of the error, of the choice
// between explicit and implicit, and of the state.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/control/adaptive_control.hpp"
#include "core/control/fixed_control.hpp"

using namespace pf;

namespace {

/// Unit masses on springs of frequency w [rad/s], size 1 m, and how a step is taken and counted. Nothing moves in
/// the mode of frequency `silent`, which explicit steps have to be short for all the same.
struct Springs {
  std::vector<double> w, x, v;
  double silent = 0;
  double time = 0;
  int explicit_steps = 0, implicit_steps = 0, given_up = 0;
  double work = 0;

  double highest() const { return std::max(silent, *std::max_element(w.begin(), w.end())); }
  /// As the simulation does it: limit, choice, trial, judgement.
  StepChoice step(StepControl& control, double end) {
    control.keep();
    if (control.wants_limit()) control.tell_limit(2 / highest());
    StepChoice choice = control.next(time, end);
    for (int tries = 0;; ++tries) {
      const double dt = choice.dt;
      std::vector<double> x1 = x, v1 = v;
      double whole = 0, left = 0;
      for (std::size_t k = 0; k < w.size(); ++k) {
        const double stiff = w[k] * w[k];
        v1[k] =
            choice.implicit ? (v[k] - dt * stiff * x[k]) / (1 + dt * dt * stiff) : v[k] - choice.kick * stiff * x[k];
        x1[k] = x[k] + dt * v1[k];
        const double e = 0.5 * (v1[k] - v[k]), after = e / (1 + dt * dt * stiff);
        whole += e * e;
        left += after * after;
      }
      StepOutcome outcome{.choice = choice};
      outcome.error_rate = choice.implicit ? std::sqrt(std::sqrt(whole * left) / static_cast<double>(w.size())) : 0;
      outcome.work = choice.implicit ? 10 : 1;
      work += outcome.work;
      outcome.newton = 2;
      if (const auto instead = control.judge(outcome, time, end, tries)) {
        choice = *instead;
        ++given_up;
        continue;
      }
      x = x1, v = v1;
      time += dt;
      if (std::abs(time - end) < 1e-12) time = end;
      outcome.time = time;
      control.accepted(outcome);
      if (control.wants_positions()) control.tell_positions(time, x);
      ++(choice.implicit ? implicit_steps : explicit_steps);
      return choice;
    }
  }
  double error(const Springs& start) const {
    double squares = 0;
    for (std::size_t k = 0; k < w.size(); ++k) {
      const double exact = start.x[k] * std::cos(w[k] * time) + start.v[k] / w[k] * std::sin(w[k] * time);
      squares += (x[k] - exact) * (x[k] - exact);
    }
    return std::sqrt(squares / static_cast<double>(w.size()));
  }
};

ControlSetup setup(double tolerance, bool may_be_explicit) {
  ControlSetup s;
  s.step = s.largest = 0.1;
  s.tolerance = tolerance;
  s.spacing = s.size = 1;
  s.dimension = 1;
  s.explicit_work = 1;
  s.limit_work = 0.1;
  s.implicit_work = 1;
  s.newton_work = 2;
  s.linear_work = 0.5;
  s.may_be_explicit = may_be_explicit;
  return s;
}

}  // namespace

namespace {

/// Root mean square over the second half of the run of the error over the time that it took to grow [1/s].
double achieved(Springs& springs, StepControl& control, double end) {
  const Springs start = springs;
  double squares = 0;
  int count = 0;
  while (springs.time < end) {
    springs.step(control, end);
    if (springs.time < end / 2) continue;
    const double rate = springs.error(start) / springs.time;
    squares += rate * rate;
    ++count;
  }
  CHECK(springs.time == end);
  return std::sqrt(squares / count);
}

}  // namespace

TEST_CASE("the error that implicit steps make in a unit of time follows the tolerance over three decades") {
  double last = 0;
  for (const double tolerance : {3e-3, 3e-4, 3e-5, 3e-6}) {
    CAPTURE(tolerance);
    AdaptiveControl control(setup(tolerance, false));
    Springs springs{.w = {2, 5}, .x = {0.1, 0}, .v = {0, 0.3}};
    const double rate = achieved(springs, control, 6);
    CHECK(springs.explicit_steps == 0);
    CHECK(rate < 1.5 * tolerance);
    CHECK(rate > 0.4 * tolerance);
    if (last > 0) CHECK(last / rate == doctest::Approx(10).epsilon(0.3));
    last = rate;
    CHECK(springs.given_up <= 4);
  }
}

TEST_CASE("symplectic Euler is held to the tolerance, too, where stability alone would not do") {
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5}) {
    CAPTURE(tolerance);
    AdaptiveControl control(setup(tolerance, true));
    Springs springs{.w = {2, 3}, .x = {0, 0.3}, .v = {1, 0}, .silent = 60};
    CHECK(achieved(springs, control, 20) < 2 * tolerance);
    CHECK(springs.explicit_steps > 20 * springs.implicit_steps);
  }
}

TEST_CASE("explicit steps are chosen where they take less counted work, implicit ones where nothing fast moves") {
  AdaptiveControl for_stiff(setup(1e-2, true));
  Springs springs{.w = {1, 2}, .x = {0.1, 0}, .v = {0, 0.1}, .silent = 5000};
  CHECK(achieved(springs, for_stiff, 2) < 1e-2);
  CHECK(springs.explicit_steps == 0);
  CHECK(springs.implicit_steps < 60);
  AdaptiveControl for_soft(setup(1e-3, true));
  springs = {.w = {1, 2}, .x = {0.1, 0}, .v = {0, 0.1}, .silent = 25};
  CHECK(achieved(springs, for_soft, 2) < 1e-3);
  CHECK(springs.implicit_steps <= 1);
}

TEST_CASE("explicit steps give way to implicit ones when the fast motion has gone, and stay away") {
  Springs springs{.w = {1, 400}, .x = {0.1, 0}, .v = {0, 40}};
  AdaptiveControl control(setup(1e-2, true));
  while (springs.time < 0.5) springs.step(control, 100);
  CHECK(springs.explicit_steps > 50);
  springs.x[1] = springs.v[1] = 0;
  const int before = springs.explicit_steps;
  while (springs.time < 3) springs.step(control, 100);
  CHECK(springs.implicit_steps > 10);
  const int until_then = springs.explicit_steps;
  CHECK(until_then < before + 150);
  while (springs.time < 4) springs.step(control, 100);
  CHECK(springs.explicit_steps == until_then);
}

TEST_CASE("a choice depends on the control's state alone, and a step that came to nothing leaves no trace in it") {
  for (const double fast : {20.0, 400.0}) {
    Springs springs{.w = {1, fast}, .x = {0.1, 0.1}, .v = {0, 0}};
    AdaptiveControl control(setup(1e-2, true)), other(setup(1e-2, true));
    for (int k = 0; k < 200; ++k) {
      REQUIRE(other.set_state(control.state()));
      CHECK(other.state() == control.state());
      const std::vector<double> before = control.state();
      Springs trial = springs;
      trial.step(other, 1000);
      Springs undone = springs;
      // As far as a cancelled step gets.
      control.keep();
      if (control.wants_limit()) control.tell_limit(2 / undone.highest());
      const StepChoice first = control.next(undone.time, 1000);
      control.retry(first);
      control.restore();
      CHECK(control.state() == before);
      springs.step(control, 1000);
      CHECK(control.state() == other.state());
      CHECK(springs.time == trial.time);
    }
  }
}

TEST_CASE("numbers that are no state are refused and change nothing") {
  AdaptiveControl control(setup(1e-2, true));
  Springs springs{.w = {1, 20}, .x = {0.1, 0.1}, .v = {0, 0}};
  for (int k = 0; k < 40; ++k) springs.step(control, 10);
  const std::vector<double> state = control.state();
  std::vector<double> longer = state, shorter = state, negative = state;
  longer.push_back(1);
  shorter.pop_back();
  CHECK_FALSE(control.set_state(longer));
  CHECK_FALSE(control.set_state(shorter));
  CHECK_FALSE(control.set_state({}));
  CHECK(control.state() == state);
  FixedControl fixed(setup(1e-2, true));
  CHECK_FALSE(fixed.set_state(state));
}

TEST_CASE("after a step that did not work out dt is halved, and grows back slowly") {
  AdaptiveControl control(setup(1, false));
  Springs springs{.w = {1}, .x = {1e-3}, .v = {0}};
  const double usual = springs.step(control, 100).dt;
  control.keep();
  const StepChoice tried = control.next(springs.time, 100);
  const StepChoice again = control.retry(tried);
  CHECK(again.dt == tried.dt / 2);
  CHECK(again.limited_by == StepLimit::failure);
  StepOutcome outcome{.choice = again, .error_rate = 1e-6, .work = 10, .newton = 2};
  outcome.retries = 1;
  outcome.time = springs.time + again.dt;
  control.accepted(outcome);
  CHECK(control.next(outcome.time, 100).dt < 1.2 * again.dt);
  CHECK(control.next(outcome.time, 100).dt < usual);
}

TEST_CASE("many Newton iterations shorten the next step") {
  AdaptiveControl control(setup(1, false));
  const StepChoice choice = control.next(0, 100);
  control.accepted({.choice = choice, .error_rate = 1e-9, .work = 100, .newton = 30, .time = choice.dt});
  const StepChoice next = control.next(choice.dt, 100);
  CHECK(next.dt < choice.dt);
  CHECK(next.limited_by == StepLimit::newton);
}

TEST_CASE("no particle crosses more than a cell, and the last steps share what is left evenly") {
  AdaptiveControl control(setup(1, false));
  StepChoice choice = control.next(0, 100);
  control.accepted({.choice = choice, .error_rate = 1e-9, .work = 10, .newton = 2, .speed = 50, .time = choice.dt});
  choice = control.next(choice.dt, 100);
  CHECK(choice.dt == doctest::Approx(1.0 / 50));
  CHECK(choice.limited_by == StepLimit::crossing);
  // 2.5 steps are left: three of equal length.
  AdaptiveControl ending(setup(1, false));
  choice = ending.next(0, 0.25);
  CHECK(choice.dt == doctest::Approx(0.25 / 3));
  CHECK(choice.limited_by == StepLimit::landing);
}
