// The question that a study answers: what is the least that this accuracy costs?
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/studies/results.hpp"

namespace pf {

/// Pointers into the rows that were asked about.
struct Cheapest {
  const StudyRow* best = nullptr;
  std::vector<const StudyRow*> ties;  ///< cost the same within the noise of the timing, and are below the bound too
};

/// The cheapest setting whose error (`column` of row_columns()) is at most `tolerance`, in the column's unit. Runs that
/// did not come well to their end do not count, nor does one without an error: it is the reference itself. Nothing
/// where no run is that good.
std::optional<Cheapest> cheapest(const Study& study, std::span<const StudyRow> rows, double tolerance,
                                 std::string_view column = "error_l2");

/// Least and greatest error of the runs that count; nothing where there are none.
std::optional<std::pair<double, double>> error_range(const Study& study, std::span<const StudyRow> rows,
                                                     std::string_view column = "error_l2");

}  // namespace pf
