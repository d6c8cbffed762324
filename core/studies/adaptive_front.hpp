// Adaptive runs against the fixed settings of the same study: what would the best of these have cost?
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/studies/row.hpp"
#include "core/studies/study.hpp"

namespace pf {

/// An adaptive run beside the front of the fixed ones: those than which no other has both a smaller error (error_l2)
/// and a smaller cost.
struct AgainstFront {
  std::size_t point = 0;  ///< the setting
  double error = 0, cost = 0;
  /// What the fixed settings cost at this error: between the points of their front along straight lines in logarithms,
  /// and the cheapest one where that is more exact than the run. NaN: none of them is as exact as the run.
  double front_cost = not_measured;
  double ratio = not_measured;  ///< cost / front_cost: 1 is on the front, less is better
};

/// One for each adaptive run that came to its end. Empty where the study has none, or no fixed run beside them.
std::vector<AgainstFront> adaptive_against_fixed(const Study& study, std::span<const StudyRow> rows);
/// The same as a file, the varied columns first; "" where there is nothing to tell.
std::string adaptive_csv(const Study& study, std::span<const StudyRow> rows);

}  // namespace pf
