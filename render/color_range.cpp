#include "render/color_range.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pf {

namespace {

/// `value` rounded up to two leading digits: 0.00123 -> 0.0013.
double round_up(double value) {
  if (value <= 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit - 1e-9) * unit;
}

/// Half widths below this are rounding noise, not data.
double smallest_width(const FieldInfo& info) {
  return info.field == Field::J ? 1e-4 : 1e-9;
}

}  // namespace

ValueRange percentile_range(std::span<const float> values, const FieldInfo& info) {
  if (info.scale == FieldScale::categorical) return {0, 255};
  constexpr std::size_t enough = 20000;
  const std::size_t stride = values.size() / enough + 1;
  std::vector<float> sample;
  for (std::size_t k = 0; k < values.size(); k += stride)
    if (std::isfinite(values[k])) sample.push_back(values[k]);
  if (sample.empty()) return {0, 1};
  const auto percentile = [&](double q) {
    const auto at = sample.begin() + std::lround(q * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), at, sample.end());
    return static_cast<double>(*at);
  };
  const double high = percentile(0.98);
  if (info.scale == FieldScale::diverging) {
    const double low = percentile(0.02);
    const double half = std::max(std::abs(low - info.centre), std::abs(high - info.centre));
    const double rounded = half > smallest_width(info) ? round_up(half) : smallest_width(info);
    return {info.centre - rounded, info.centre + rounded};
  }
  if (high <= smallest_width(info)) return {0, 1};
  return {0, round_up(high)};  // magnitudes begin at zero
}

const ValueRange& AutoRange::update(std::span<const float> values, const FieldInfo& info) {
  const ValueRange now = percentile_range(values, info);
  const double width = range_.max - range_.min, slack = 0.05 * width;
  const bool inside = now.min >= range_.min - slack && now.max <= range_.max + slack;
  const bool fills = now.max - now.min >= 0.5 * width;
  if (!known_ || !inside || !fills) {
    range_ = now;
    // Some room when it grows, so that a rising field does not change the range in every frame.
    if (known_ && !inside && info.scale == FieldScale::sequential)
      range_.max = round_up(now.min + 1.2 * (now.max - now.min));
    if (known_ && !inside && info.scale == FieldScale::diverging) {
      const double half = round_up(0.6 * (now.max - now.min));
      range_ = {info.centre - half, info.centre + half};
    }
  }
  known_ = !values.empty();
  return range_;
}

}  // namespace pf
