// Steps of one length: t_n = n step; the last one is shortened to land on the end. After a failure they are halved and
// doubled again with each accepted one.
#pragma once

#include "core/control/step_control.hpp"

namespace pf {

class FixedControl final : public StepControl {
 public:
  explicit FixedControl(const ControlSetup& setup)
      : step_(setup.step), implicit_(setup.implicit), limit_(setup.step), kept_(setup.step) {}

  bool adaptive() const override { return false; }
  StepChoice next(double time, double end) override;
  StepChoice retry(const StepChoice& failed) override;
  void accepted(const StepOutcome& outcome) override;
  void keep() override { kept_ = limit_; }
  void restore() override { limit_ = kept_; }
  std::vector<double> state() const override { return {limit_}; }
  bool set_state(std::span<const double> state) override;

 private:
  double step_;
  bool implicit_;
  double limit_;  ///< after a retry: at most this
  double kept_;
};

}  // namespace pf
