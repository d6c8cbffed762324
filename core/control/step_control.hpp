// Step control: how long the next step is and, where that is open, by which kind of integrator. It proposes, is told
// what came of it, and proposes again; it knows numbers only, no particle and no grid.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/step_report.hpp"

namespace pf {

/// What a control knows of a scene.
struct ControlSetup {
  double step = 0;        ///< time.step [s]
  double largest = 0;     ///< a step is never longer [s]
  double tolerance = 0;   ///< relative displacement error a unit of time [1/s]
  double spacing = 0;     ///< dx [m]
  double size = 0;        ///< of the bodies: what "relative" refers to [m]
  double wave_speed = 0;  ///< of the fastest material at rest [m/s]
  int dimension = 2;
  /// Counted work of an explicit step, and of an implicit one as the sum of a fixed part, a part a Newton iteration and
  /// a part an iteration of its linear solver (core/work_weights.hpp).
  double explicit_work = 0, limit_work = 0, implicit_work = 0, newton_work = 0, linear_work = 0;
  bool may_be_explicit = false;  ///< adaptive: symplectic Euler may be chosen
  bool implicit = true;          ///< fixed: what the scene's integrator is
};

/// A step to be taken.
struct StepChoice {
  double dt = 0;  ///< [s]
  bool implicit = true;
  StepLimit limited_by = StepLimit::fixed;
  /// Of explicit steps: over what time forces change the velocities before these move anything [s]; 0: dt. Half of the
  /// step before and half of this one make leapfrog of symplectic Euler, whatever the steps' lengths.
  double kick = 0;
};

/// What a control is told of a step.
struct StepOutcome {
  StepChoice choice;
  double error_rate = 0;  ///< estimated, relative to the bodies' size, a unit of time [1/s]
  double work = 0;        ///< counted, of the attempt that was accepted
  int newton = 0;         ///< iterations
  double speed = 0;       ///< of the fastest particle [m/s]
  int retries = 0;
  double time = 0;  ///< at its end [s]
};

class StepControl {
 public:
  virtual ~StepControl() = default;
  virtual bool adaptive() const = 0;
  /// Whether next() wants to know the explicit limit of the present state.
  virtual bool wants_limit() const { return false; }
  virtual void tell_limit(double /*limit*/) {}
  /// Whether explicit steps may be chosen: not while the mouse holds the material, whose spring no limit knows of.
  virtual void allow_explicit(bool /*allowed*/) {}
  /// The step after `time`, at most to `end`.
  virtual StepChoice next(double time, double end) = 0;
  /// Judges the estimated error of a step from `time` before it is taken: another choice where it is too large.
  /// `given_up`: how often that has happened to this step.
  virtual std::optional<StepChoice> judge(const StepOutcome& /*tried*/, double /*time*/, double /*end*/,
                                          int /*given_up*/) {
    return std::nullopt;
  }
  /// After a step that did not work out.
  virtual StepChoice retry(const StepChoice& failed) = 0;
  virtual void accepted(const StepOutcome& outcome) = 0;
  /// Whether the particles' places are wanted after this accepted step, and the places over the bodies' size: by id,
  /// one number a dimension.
  virtual bool wants_positions() const { return false; }
  virtual void tell_positions(double /*time*/, std::span<const double> /*x*/) {}
  /// What is reported beside the choice.
  virtual void report(ControlReport& /*report*/) const {}
  /// keep() before a step, restore() where it came to nothing: to the bit.
  virtual void keep() = 0;
  virtual void restore() = 0;
  /// All that the choice of later steps depends on.
  virtual std::vector<double> state() const = 0;
  /// False, and nothing is changed, where the numbers are not a state.
  virtual bool set_state(std::span<const double> state) = 0;
};

struct StepControlInfo {
  std::string_view name, label, about;
};
std::span<const StepControlInfo> step_controls();
/// Throws std::invalid_argument for an unknown name.
std::unique_ptr<StepControl> make_step_control(std::string_view name, const ControlSetup& setup);

}  // namespace pf
