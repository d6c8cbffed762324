#include "core/control/fixed_control.hpp"

#include <algorithm>
#include <cmath>

namespace pf {

StepChoice FixedControl::next(double time, double end) {
  double target = (std::floor(time / step_ + 1e-9) + 1) * step_;
  target = std::min(target, end);
  return {std::min(target - time, limit_), implicit_, StepLimit::fixed};
}

StepChoice FixedControl::retry(const StepChoice& failed) {
  return {failed.dt / 2, failed.implicit, StepLimit::failure};
}

void FixedControl::accepted(const StepOutcome& outcome) {
  limit_ = outcome.retries > 0 ? outcome.choice.dt : std::min(2 * limit_, step_);
}

bool FixedControl::set_state(std::span<const double> state) {
  if (state.size() != 1) return false;
  limit_ = state[0];
  return true;
}

}  // namespace pf
