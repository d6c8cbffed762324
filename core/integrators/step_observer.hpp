// Somebody who looks on while a step is made, and changes nothing (core/step/step_recorder.hpp).
#pragma once

#include "core/solvers/newton_observer.hpp"

namespace pf {

class StepObserver : public NewtonObserver {
 public:
  /// A stage begins: see Stage (core/integrators/stage.hpp). `inner` may be null.
  virtual void stage(double scale, const Vector& u_free, const Vector& loads, const Vector* inner) = 0;
};

}  // namespace pf
