#include "core/charts/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace pf {
namespace {

double power(int exponent) {
  return std::pow(10.0, exponent);
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

/// 1, 2, 5, 10, 20, ... : the k-th, k may be negative.
struct Step {
  int decade = 0, place = 0;
  double size() const {
    constexpr double mantissa[] = {1, 2, 5};
    return decade < 0 ? mantissa[place] / power(-decade) : mantissa[place] * power(decade);
  }
  Step next() const { return place < 2 ? Step{decade, place + 1} : Step{decade + 1, 0}; }
};

TickSet with_step(double min, double max, const Step& step) {
  const double size = step.size(), slack = 1e-9 * size;
  const double first = std::ceil((min - slack) / size), last = std::floor((max + slack) / size);
  TickSet set;
  double largest = std::max(std::abs(first), std::abs(last)) * size;
  if (largest == 0) largest = std::max(std::abs(min), std::abs(max));  // zero alone: the range says of what size
  if (largest >= 1e4 * (1 - 1e-12) || (largest > 0 && largest < 1e-2)) {
    set.exponent = 3 * static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-12));
  }
  const int decimals = std::clamp(set.exponent - step.decade, 0, 15);
  for (double k = first; k <= last; ++k) {
    const double value = step.decade < 0 ? k * (size * power(-step.decade)) / power(-step.decade) : k * size;
    // Scaled through the integer k, so that 3 * 0.1 is 0.3.
    const int shift = step.decade - set.exponent;
    constexpr double mantissa[] = {1, 2, 5};
    const double scaled = k * mantissa[step.place];
    const double shown = shift < 0 ? scaled / power(-shift) : scaled * power(shift);
    set.major.push_back({value, k == 0 ? "0" : fixed_text(shown, decimals)});
  }
  return set;
}

void drop_labels(TickSet& set, const LabelsFit& fit) {
  while (!set.major.empty() && !fit(set.major)) {
    std::vector<Tick> fewer;
    for (std::size_t k = 0; k < set.major.size(); k += 2) fewer.push_back(set.major[k]);
    if (fewer.size() == set.major.size()) fewer.clear();
    set.major = std::move(fewer);
  }
}

/// Labels of numbers on a logarithmic axis: all plain when the range is near 1, else all with powers.
std::string logarithmic_label(int mantissa, int exponent, bool plain) {
  if (plain) return fixed_text(mantissa * power(exponent), std::max(0, -exponent));
  return mantissa == 1 ? power_of_ten(exponent) : std::to_string(mantissa) + "×" + power_of_ten(exponent);
}

struct Decades {
  int lowest = 0, highest = 0;  ///< powers of ten within the range
  bool plain = false;
  double min = 0, max = 0;
  bool holds(double value) const { return value >= min * (1 - 1e-9) && value <= max * (1 + 1e-9); }
};

/// Ticks at every `stride`-th power of ten.
TickSet at_powers(const Decades& range, int stride) {
  TickSet set;
  for (int e = range.lowest - 1; e <= range.highest; ++e) {
    if (range.holds(power(e))) {
      (e % stride == 0 ? set.major : set.minor).push_back({power(e), ""});
      if (e % stride == 0) set.major.back().label = logarithmic_label(1, e, range.plain && stride == 1);
    }
    for (int m = 2; stride == 1 && m < 10; ++m) {
      if (range.holds(m * power(e))) set.minor.push_back({m * power(e), ""});
    }
  }
  return set;
}

/// Ticks at 1, 2, 5 of each decade.
TickSet at_one_two_five(const Decades& range) {
  TickSet set;
  for (int e = range.lowest - 1; e <= range.highest; ++e) {
    for (int m = 1; m < 10; ++m) {
      if (!range.holds(m * power(e))) continue;
      const bool major = m == 1 || m == 2 || m == 5;
      (major ? set.major : set.minor).push_back({m * power(e), ""});
      if (major) set.major.back().label = logarithmic_label(m, e, range.plain);
    }
  }
  return set;
}

}  // namespace

TickSet linear_ticks(double min, double max, int most, const LabelsFit& fit) {
  most = std::max(most, 2);
  const double rough = (max - min) / most;
  Step step{static_cast<int>(std::floor(std::log10(rough) - 1e-9)), 0};
  TickSet set;
  for (int attempt = 0; attempt < 12; ++attempt, step = step.next()) {
    if ((max - min) / step.size() > 2.0 * most) continue;  // far too many to make
    TickSet next = with_step(min, max, step);
    if (static_cast<int>(next.major.size()) > most) continue;
    if (next.major.size() < 2 && !set.major.empty()) break;
    set = std::move(next);
    if (fit(set.major)) return set;
  }
  drop_labels(set, fit);
  return set;
}

TickSet logarithmic_ticks(double min, double max, int most, const LabelsFit& fit) {
  most = std::max(most, 2);
  Decades range{.lowest = static_cast<int>(std::ceil(std::log10(min) - 1e-9)),
                .highest = static_cast<int>(std::floor(std::log10(max) + 1e-9)),
                .min = min,
                .max = max};
  const int count = range.highest - range.lowest + 1;
  if (count <= 2) {
    range.plain = range.lowest >= -3 && range.highest <= 4;
    TickSet set = at_one_two_five(range);
    if (set.major.size() >= 2 && static_cast<int>(set.major.size()) <= most && fit(set.major)) return set;
    if (count < 2) {
      // Less than a decade: equal steps read better than bare powers, but only if no prefix hides in the title.
      set = linear_ticks(min, max, most, fit);
      if (set.exponent != 0) {
        for (Tick& tick : set.major) tick.label = number_text(tick.value, 3);
        set.exponent = 0;
        drop_labels(set, fit);
      }
      return set;
    }
  }
  range.plain = range.lowest >= -2 && range.highest <= 3;
  TickSet set;
  for (int stride = 1; stride <= std::max(1, count); ++stride) {
    TickSet next = at_powers(range, stride);
    if (stride > 1 && next.major.size() < 2) break;
    set = std::move(next);
    if (static_cast<int>(set.major.size()) <= most && fit(set.major)) return set;
  }
  drop_labels(set, fit);
  return set;
}

std::string fixed_text(double value, int decimals) {
  std::array<char, 400> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  std::string text = buffer.data();
  if (text.find_first_not_of("-0.") == std::string::npos && text[0] == '-') text.erase(0, 1);
  replace_all(text, "-", "−");
  return text;
}

std::string power_of_ten(int exponent) {
  constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = "10";
  if (exponent < 0) text += "⁻";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}

std::string number_text(double value, int digits) {
  if (std::isnan(value)) return "not a number";
  if (std::isinf(value)) return value < 0 ? "−∞" : "∞";
  if (value == 0) return "0";
  const double rounding = 1 + 0.5 * std::pow(10.0, -digits);
  int exponent = static_cast<int>(std::floor(std::log10(std::abs(value) * rounding)));
  if (exponent >= -3 && exponent < 6) return fixed_text(value, std::max(0, digits - 1 - exponent));
  std::array<char, 64> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.*e", digits - 1, value);
  std::string text = buffer.data();
  const std::size_t e = text.find('e');
  exponent = std::stoi(text.substr(e + 1));
  text.resize(e);
  replace_all(text, "-", "−");
  return text + "×" + power_of_ten(exponent);
}

std::string axis_title(const std::string& title, const std::string& unit, int exponent) {
  constexpr const char* prefixes[] = {"f", "p", "n", "µ", "m", "", "k", "M", "G", "T", "P"};
  // A prefix belongs to the first symbol of the unit, and must not be raised to a power with it.
  constexpr std::string_view prefixed[] = {"m", "s", "J", "N", "Pa", "W", "Hz", "B"};
  const std::size_t end = std::min(unit.find_first_of(" /*."), unit.size());
  const bool takes_prefix = exponent >= -15 && exponent <= 15 &&
                            std::ranges::find(prefixed, std::string_view(unit).substr(0, end)) != std::end(prefixed);
  std::string inside;
  if (exponent == 0) {
    inside = unit;
  } else if (takes_prefix) {
    inside = prefixes[exponent / 3 + 5] + unit;
  } else {
    inside = power_of_ten(exponent) + (unit.empty() ? "" : " " + unit);
  }
  if (inside.empty()) return title;
  return title.empty() ? inside : title + " [" + inside + "]";
}

}  // namespace pf
