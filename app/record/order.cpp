#include "app/record/order.hpp"

#include <algorithm>
#include <cmath>

namespace pf::app {

bool FrameClock::due(long step, double time, double dt) {
  if (step <= newest_) return false;
  newest_ = step;
  if (step < step_) return false;
  if (every_.seconds <= 0) return (step - step_) % std::max(every_.steps, 1L) == 0;
  const double past = time - time_ + 1e-9 * dt;
  if (past < static_cast<double>(frame_) * every_.seconds) return false;
  // A step over several of them is one frame.
  frame_ = 1 + static_cast<long>(std::floor(past / every_.seconds));
  return true;
}

}  // namespace pf::app
