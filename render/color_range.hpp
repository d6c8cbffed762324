// Which values the ends of the colour map stand for.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/diagnostics/fields.hpp"

namespace pf {

struct ValueRange {
  double min = 0, max = 1;
  bool operator==(const ValueRange&) const = default;
};

/// How values become colours.
enum class ColorScale {
  from_zero,    ///< magnitudes: 0 to the largest
  symmetric,    ///< about FieldInfo::centre, with a diverging map
  spread,       ///< from the smallest to the largest
  logarithmic,  ///< of magnitudes
  categorical,
};
/// What a field is drawn with; `symmetric`: nothing leaves it to the field.
ColorScale color_scale(const FieldInfo& info, bool logarithmic, std::optional<bool> symmetric);
/// The colour map that belongs to it.
FieldScale map_of(ColorScale scale);
/// Where a value lies between the ends of the map, 0 to 1 and beyond; NaN stays NaN.
double map_position(double value, const ValueRange& range, ColorScale scale);

/// Follows the 2nd to 98th percentile of a field over time, with hysteresis: the range stays while the data fill
/// most of it, so that the picture does not flicker.
/// Depends on the sequence of updates only.
class AutoRange {
 public:
  const ValueRange& update(std::span<const float> values, const FieldInfo& info, ColorScale scale);
  const ValueRange& update(std::span<const float> values, const FieldInfo& info) {
    return update(values, info, color_scale(info, false, {}));
  }
  const ValueRange& range() const { return range_; }
  void reset() { known_ = false; }

 private:
  ValueRange range_;
  bool known_ = false;
};

/// 2nd to 98th percentile (of at most 20000 evenly chosen finite values), made symmetric, widened where it
/// vanishes and rounded outwards to round numbers. {0, 1} without values. Logarithmic: of magnitudes other than 0, at
/// most `most_decades` of them.
ValueRange percentile_range(std::span<const float> values, const FieldInfo& info, ColorScale scale);
inline ValueRange percentile_range(std::span<const float> values, const FieldInfo& info) {
  return percentile_range(values, info, color_scale(info, false, {}));
}
inline constexpr double most_decades = 6;

/// How many of the values lie in each of `bins` equal parts of the map; the first and the last have those beyond, too.
/// Of at most 200000 evenly chosen ones, finite ones only.
std::vector<float> histogram(std::span<const float> values, const ValueRange& range, ColorScale scale, int bins);

}  // namespace pf
