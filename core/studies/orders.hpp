// Orders of convergence from measured errors.
#pragma once

#include <span>

namespace pf {

struct FittedOrder {
  double order = 0;     ///< slope of log error over log x; NaN where no three points lie on a line
  double residual = 0;  ///< largest distance of a point from it [decades]
  std::size_t points = 0;
  double from = 0, to = 0;  ///< x of the first and the last point of the fit
};

/// The straight part of a convergence curve: of all runs of three or more neighbouring points that a line in log-log
/// fits within 0.05 decades (12 %), the longest; of equally long ones that with the larger x, away from rounding and
/// from the floor that another error sets. Points whose x or error is not positive are left out.
FittedOrder fit_order(std::span<const double> x, std::span<const double> error);

}  // namespace pf
