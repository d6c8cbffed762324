// Somebody who looks on while Newton's method works, and changes nothing.
#pragma once

#include "core/step_report.hpp"

namespace pf {

class NewtonObserver {
 public:
  virtual ~NewtonObserver() = default;
  /// A minimisation begins, maybe where an earlier one ended (a later stage, friction bounds that have moved).
  virtual void begin() = 0;
  /// An iterate, before anything is done about it. `left`: what of dE/du no constraint, wall or friction takes [N];
  /// `record` knows the residual and the energy.
  virtual void iterate(const Vector& u, const Vector& left, const NewtonIteration& record) = 0;
};

}  // namespace pf
