// Numbers for people: sensible digits, SI prefixes, and back again from what was typed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pf::app {

/// "100 kPa", "16.7 ms", "0.95", "10⁻⁶": at most `digits` significant digits, a prefix where the unit takes one
/// (m s Pa N J W Hz and what starts with J/), none otherwise. NaN reads "not a number".
std::string quantity(double value, std::string_view unit, int digits = 4);
/// "m/s^2" -> "m/s²".
std::string pretty_unit(std::string_view unit);
/// The number alone, shortest form that reads back as the same double; what a text field starts with.
std::string plain_number(double value);
/// Reads "2.5e4", "25 kPa", "25k", "1/60", "-9.81 m/s²", "4.5×10⁻⁷": an expression of numbers, then optionally a prefix
/// and the unit itself. Nothing when it is not that.
std::optional<double> parse_quantity(std::string_view text, std::string_view unit);
/// Rounds to `digits` significant digits: what dragging a slider sets.
double rounded(double value, int digits);

}  // namespace pf::app
