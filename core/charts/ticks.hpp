// Round numbers along an axis, and how they are written.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pf {

struct Tick {
  double value = 0;
  std::string label;  ///< "" for a minor tick or one whose label would crowd
};

struct TickSet {
  std::vector<Tick> major, minor;
  int exponent = 0;  ///< labels are values / 10^exponent, a multiple of 3; the axis title says so
};

/// Whether labels at these places fit beside one another.
using LabelsFit = std::function<bool(const std::vector<Tick>&)>;

/// Steps of 1, 2 or 5 times a power of ten, at most `most` ticks, as many as fit; all within [min, max]. Needs
/// min < max, both finite.
TickSet linear_ticks(double min, double max, int most, const LabelsFit& fit);
/// Powers of ten with minor ticks between; over less than a decade the linear steps. Needs 0 < min < max.
TickSet logarithmic_ticks(double min, double max, int most, const LabelsFit& fit);

/// `value` with `decimals` digits after the point and a true minus sign.
std::string fixed_text(double value, int decimals);
/// About `digits` significant digits for people: "0.0123", "4.50×10⁻⁷".
std::string number_text(double value, int digits = 4);
/// "10⁻³".
std::string power_of_ten(int exponent);
/// "Total energy [kJ]"; where the unit takes no prefix "[10³ kg m/s]", without unit "[10³]".
std::string axis_title(const std::string& title, const std::string& unit, int exponent);

}  // namespace pf
