// What a study's numbers must be, and whether they are.
#pragma once

#include <span>

#include "core/studies/row.hpp"
#include "core/studies/study.hpp"

namespace pf {

/// The settings whose rows a check looks at, in the order of the study.
std::vector<std::size_t> matching_points(const Study& study, const StudyCheck& check);

struct CheckResult {
  std::vector<double> values;   ///< what was judged; NaN where it could not be measured
  double worst = not_measured;  ///< of them: the furthest out of bounds, or else the nearest to them
  bool passed = false;
  std::string reason;  ///< why there is no value
};

/// `rows`: the study's rows, by setting; missing ones fail.
CheckResult evaluate(const Study& study, const StudyCheck& check, std::span<const StudyRow> rows);

/// "at most 2e-5", "1.8 to 2.3".
std::string bounds_text(const StudyCheck& check);

}  // namespace pf
