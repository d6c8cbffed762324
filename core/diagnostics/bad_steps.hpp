// Steps worth a look: where a run got into trouble, told from its reports.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/step_report.hpp"

namespace pf {

struct BadStep {
  long step = 0;
  std::string why;  ///< one sentence for the user
};

/// Whether the last of `reports`, which follow each other, tells of trouble: the step had to be begun again with a
/// smaller dt, its residual is above `tolerance`, a particle is nearly turned inside out (J < 0.1, and was not before),
/// or the total energy rose at once by far more than in the steps before.
std::optional<BadStep> bad_step(std::span<const StepReport> reports, double tolerance);

}  // namespace pf
