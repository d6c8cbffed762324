// Which values the ends of the colour map stand for.
#pragma once

#include <span>

#include "core/diagnostics/fields.hpp"

namespace pf {

struct ValueRange {
  double min = 0, max = 1;
  bool operator==(const ValueRange&) const = default;
};

/// Follows the 2nd to 98th percentile of a field over time, with hysteresis: the range stays while the data fill
/// most of it, so that the picture does not flicker. Diverging fields: symmetric about FieldInfo::centre.
/// Depends on the sequence of updates only.
class AutoRange {
 public:
  const ValueRange& update(std::span<const float> values, const FieldInfo& info);
  const ValueRange& range() const { return range_; }
  void reset() { known_ = false; }

 private:
  ValueRange range_;
  bool known_ = false;
};

/// 2nd to 98th percentile (of at most 20000 evenly chosen finite values), made symmetric, widened where it
/// vanishes and rounded outwards to round numbers. {0, 1} without values.
ValueRange percentile_range(std::span<const float> values, const FieldInfo& info);

}  // namespace pf
