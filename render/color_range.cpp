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

double round_down(double value) {
  if (value <= 0) return -round_up(-value);
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::floor(value / unit + 1e-9) * unit;
}

/// Half widths below this are rounding noise, not data.
double smallest_width(const FieldInfo& info) {
  return info.centre == 1 ? 1e-4 : 1e-9;
}

constexpr std::size_t enough = 20000;

ValueRange symmetric_range(double low, double high, const FieldInfo& info) {
  const double half = std::max(std::abs(low - info.centre), std::abs(high - info.centre));
  const double rounded = half > smallest_width(info) ? round_up(half) : smallest_width(info);
  return {info.centre - rounded, info.centre + rounded};
}

ValueRange spread_range(double low, double high, const FieldInfo& info) {
  if (high - low <= smallest_width(info)) return {low - smallest_width(info), high + smallest_width(info)};
  // To two digits of the width, so that it does not grow by rounding.
  const double unit = std::pow(10.0, std::floor(std::log10(high - low)) - 1);
  return {std::floor(low / unit + 1e-9) * unit, std::ceil(high / unit - 1e-9) * unit};
}

}  // namespace

ColorScale color_scale(const FieldInfo& info, bool logarithmic, std::optional<bool> symmetric) {
  if (info.scale == FieldScale::categorical) return ColorScale::categorical;
  if (logarithmic) return ColorScale::logarithmic;
  if (symmetric.value_or(info.scale == FieldScale::diverging)) return ColorScale::symmetric;
  return info.scale == FieldScale::diverging ? ColorScale::spread : ColorScale::from_zero;
}

FieldScale map_of(ColorScale scale) {
  if (scale == ColorScale::categorical) return FieldScale::categorical;
  return scale == ColorScale::symmetric ? FieldScale::diverging : FieldScale::sequential;
}

double map_position(double value, const ValueRange& range, ColorScale scale) {
  if (scale != ColorScale::logarithmic) return (value - range.min) / (range.max - range.min);
  return std::log(std::abs(value) / range.min) / std::log(range.max / range.min);
}

ValueRange percentile_range(std::span<const float> values, const FieldInfo& info, ColorScale scale) {
  if (scale == ColorScale::categorical) return {0, 255};
  const bool logarithmic = scale == ColorScale::logarithmic;
  const std::size_t stride = values.size() / enough + 1;
  std::vector<float> sample;
  for (std::size_t k = 0; k < values.size(); k += stride)
    if (std::isfinite(values[k]) && (!logarithmic || values[k] != 0))
      sample.push_back(logarithmic ? std::abs(values[k]) : values[k]);
  if (sample.empty()) return logarithmic ? ValueRange{1e-3, 1} : ValueRange{0, 1};
  const auto percentile = [&](double q) {
    const auto at = sample.begin() + std::lround(q * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), at, sample.end());
    return static_cast<double>(*at);
  };
  const double high = percentile(0.98), low = percentile(0.02);
  if (scale == ColorScale::symmetric) return symmetric_range(low, high, info);
  if (scale == ColorScale::spread) return spread_range(low, high, info);
  if (logarithmic) {
    const double top = round_up(high);
    return {std::max(round_down(std::min(low, 0.5 * top)), top * std::pow(10, -most_decades)), top};
  }
  if (high <= smallest_width(info)) return {0, 1};
  return {0, round_up(high)};  // magnitudes begin at zero
}

std::vector<float> histogram(std::span<const float> values, const ValueRange& range, ColorScale scale, int bins) {
  std::vector<float> counts(static_cast<std::size_t>(bins), 0.F);
  const std::size_t stride = values.size() / (10 * enough) + 1;
  for (std::size_t k = 0; k < values.size(); k += stride) {
    const double u = map_position(values[k], range, scale);
    if (std::isnan(u)) continue;
    counts[static_cast<std::size_t>(std::clamp(std::floor(u * bins), 0.0, bins - 1.0))] += 1;
  }
  return counts;
}

const ValueRange& AutoRange::update(std::span<const float> values, const FieldInfo& info, ColorScale scale) {
  const ValueRange now = percentile_range(values, info, scale);
  if (scale == ColorScale::logarithmic || scale == ColorScale::spread) {
    // Both ends move: kept while they are near, in decades or in widths.
    const auto place = [&](double value) { return scale == ColorScale::spread ? value : std::log10(value); };
    const double wide = known_ ? place(range_.max) - place(range_.min) : 0;
    const bool near = known_ && std::abs(place(now.min) - place(range_.min)) < 0.3 * wide &&
                      std::abs(place(now.max) - place(range_.max)) < (scale == ColorScale::spread ? 0.1 : 0.05) * wide;
    if (!near) range_ = now;
    known_ = !values.empty();
    return range_;
  }
  const double width = range_.max - range_.min, slack = 0.05 * width;
  const bool inside = now.min >= range_.min - slack && now.max <= range_.max + slack;
  const bool fills = now.max - now.min >= 0.5 * width;
  if (!known_ || !inside || !fills) {
    range_ = now;
    // Some room when it grows, so that a rising field does not change the range in every frame.
    if (known_ && !inside && scale == ColorScale::from_zero) range_.max = round_up(now.min + 1.2 * (now.max - now.min));
    if (known_ && !inside && scale == ColorScale::symmetric) {
      const double half = round_up(0.6 * (now.max - now.min));
      range_ = {info.centre - half, info.centre + half};
    }
  }
  known_ = !values.empty();
  return range_;
}

}  // namespace pf
