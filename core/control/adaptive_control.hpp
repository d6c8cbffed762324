// Adaptive steps: implicit ones as long as the tolerance on the estimated error lets them be, explicit ones as long as
// they are stable and exact enough, whichever is predicted to take less counted work a second of simulated time.
// Counted work, never a clock: the same steps whatever the machine and the number of threads.
#pragma once

#include "core/control/motion_marks.hpp"
#include "core/control/step_control.hpp"

namespace pf {

/// Error estimates (docs/theory.md, "Adaptive steps"), relative to the bodies' size and a unit of time:
/// - implicit: what the step measures (Integrator, StepError), of first order in dt;
/// - explicit: dt^2/24 of the motion's third derivative, the error of leapfrog, which symplectic Euler is when its
///   velocities stand half a step before its places (StepChoice::kick).
class AdaptiveControl final : public StepControl {
 public:
  explicit AdaptiveControl(const ControlSetup& setup);

  bool adaptive() const override { return true; }
  bool wants_limit() const override;
  void tell_limit(double limit) override;
  void allow_explicit(bool allowed) override;
  StepChoice next(double time, double end) override;
  std::optional<StepChoice> judge(const StepOutcome& tried, double time, double end, int given_up) override;
  StepChoice retry(const StepChoice& failed) override;
  void accepted(const StepOutcome& outcome) override;
  bool wants_positions() const override;
  void tell_positions(double time, std::span<const double> x) override;
  void report(ControlReport& report) const override;
  void keep() override { kept_ = now_; }
  void restore() override { now_ = kept_; }
  std::vector<double> state() const override;
  bool set_state(std::span<const double> state) override;

 private:
  /// Numbers only, so that a state is saved and compared as they stand. Truths are 0 or 1.
  struct State {
    double begun = 0, implicit = 1, barred = 0;
    double dt_implicit = 0;                   ///< of the next implicit step [s]
    double implicit_target = 0;               ///< what the tolerance would allow [s]
    double mean_square = 0;                   ///< running mean of (error rate / dt)^2 [1/s^4]; 0: none yet
    double floor = 0;                         ///< part of the estimate that no shorter step makes smaller [1/s]
    double refused_dt = 0, refused_rate = 0;  ///< of the attempt at this step that was given up last; 0: none
    double newton_bound = 0;                  ///< 1: Newton's iterations hold dt_implicit down
    double growth = 1.5;                      ///< of implicit steps, at most
    double work_ratio = 1;                    ///< counted work of implicit steps over the prediction
    double counted = 0;                       ///< 1: work_ratio is counted
    double dt_stable = 0;                     ///< what explicit steps may have for stability [s]
    double dt_exact = 0;                      ///< ... for the tolerance [s]; 0: no bound known
    double dt_mended = 0;                     ///< ... after a failure [s]; 0: no bound
    double limit = 0, age = 0;                ///< explicit limit [s], and steps since it was found
    double speed = 0;                         ///< of the fastest particle [m/s]
    double error_rate = 0;                    ///< newest estimate [1/s]
    double votes = 0;                         ///< steps in a row that spoke for the other integrator
    double since = 0, patience = 0;  ///< steps since the last change of integrator; so many before the next one
    double jerk = 0;                 ///< largest of late of the motion's third derivative, over the size [1/s^3]
    double mark_interval = 0, next_mark = 0;  ///< [s]
    double behind = 0;  ///< half of the explicit step before: velocities stand so far before the places [s]
    double time = 0;
  };

  double implicit_work(double dt) const;
  double implicit_cost() const;
  double explicit_step() const;
  double explicit_cost() const;
  void go_explicit();
  void go_implicit(double dt);
  void accepted_implicit(const StepOutcome& outcome);
  void accepted_explicit(const StepOutcome& outcome);
  void learn_work(const StepOutcome& outcome);
  bool may_be_explicit() const { return setup_.may_be_explicit && now_.barred == 0; }

  ControlSetup setup_;
  State now_, kept_;
  MotionMarks marks_;
};

}  // namespace pf
