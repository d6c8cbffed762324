#include "app/widgets/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "core/charts/ticks.hpp"
#include "core/math/expression.hpp"

namespace pf::app {

namespace {

constexpr std::string_view minus = "\xe2\x88\x92";

struct Prefix {
  std::string_view text;
  double factor;
};
constexpr std::array<Prefix, 7> prefixes{
    {{"G", 1e9}, {"M", 1e6}, {"k", 1e3}, {"", 1}, {"m", 1e-3}, {"\xc2\xb5", 1e-6}, {"n", 1e-9}}};

bool takes_prefix(std::string_view unit) {
  constexpr std::array<std::string_view, 7> whole{"m", "s", "Pa", "N", "J", "W", "Hz"};
  return std::find(whole.begin(), whole.end(), unit) != whole.end() || unit.starts_with("J/");
}

/// A true minus sign and a power of ten, as charts have them.
std::string for_people(std::string text) {
  if (const std::size_t e = text.find('e'); e != std::string::npos && e > 0) {
    const std::string power = power_of_ten(std::stoi(text.substr(e + 1)));
    text.resize(e);
    text = text == "1" || text == "-1" ? text.substr(0, text.size() - 1) + power : text + "\xc3\x97" + power;
  }
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at)) text.replace(at, 1, minus);
  return text;
}

/// The other way: "4.5×10⁻⁷" as "4.5e-7", "10³" as "1e3".
std::string for_machines(std::string_view text) {
  constexpr std::array<std::string_view, 10> superscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  constexpr std::string_view times = "×", raised_minus = "⁻";
  std::string out;
  bool raised = false;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    const auto digit =
        std::find_if(superscripts.begin(), superscripts.end(), [&](std::string_view d) { return rest.starts_with(d); });
    const bool sign = rest.starts_with(raised_minus);
    if (!sign && digit == superscripts.end()) {
      raised = false;
      const std::string_view taken = rest.starts_with(times)   ? times
                                     : rest.starts_with(minus) ? minus
                                                               : rest.substr(0, 1);
      out += taken == times ? "*" : taken == minus ? "-" : taken;
      i += taken.size();
      continue;
    }
    if (!raised) out += '^';
    raised = true;
    out += sign ? std::string("-") : std::to_string(digit - superscripts.begin());
    i += sign ? raised_minus.size() : digit->size();
  }
  return out;
}

/// printf's %g without the exponent's leading zeros and plus sign.
std::string shortest(double value, int digits) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  std::string text = buffer.data();
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::string exponent = text.substr(e + 1);
  const bool negative = exponent.front() == '-';
  exponent.erase(0, std::min(exponent.find_first_not_of("+-0"), exponent.size()));
  return text.substr(0, e) + (negative ? "e-" : "e") + exponent;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::optional<double> number_in(std::string_view typed) {
  if (typed.empty()) return std::nullopt;
  try {
    const Expression expression = Expression::compile(for_machines(typed), {}, mask_none);
    const std::array<double, variable_count> none{};
    const double value = expression(none);
    if (std::isfinite(value)) return value;
  } catch (const ExpressionError&) {
  }
  return std::nullopt;
}

}  // namespace

double rounded(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  return std::stod(shortest(value, digits));
}

std::string pretty_unit(std::string_view unit) {
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool power = unit[i] == '^' && i + 1 < unit.size() && (unit[i + 1] == '2' || unit[i + 1] == '3');
    if (!power) {
      text += unit[i];
    } else {
      text += unit[++i] == '2' ? "\xc2\xb2" : "\xc2\xb3";
    }
  }
  return text;
}

std::string plain_number(double value) {
  std::array<char, 40> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string("0");
}

std::string quantity(double value, std::string_view unit, int digits) {
  if (std::isnan(value)) return "not a number";
  if (std::isinf(value)) return for_people(value < 0 ? "-infinity" : "infinity");
  if (unit.empty()) {
    const double size = std::abs(value);
    // Plain notation up to a million; whole numbers keep all their digits.
    if (size >= 1 && size < 1e6 && value == std::round(value)) return for_people(shortest(value, 7));
    return for_people(shortest(value, digits));
  }
  const std::string text = pretty_unit(unit);
  if (!takes_prefix(unit) || value == 0) return for_people(shortest(value, digits)) + " " + text;
  const double size = std::abs(rounded(value, digits));
  const Prefix* chosen = &prefixes.back();
  for (const Prefix& p : prefixes)
    if (size >= p.factor) {
      chosen = &p;
      break;
    }
  if (chosen->factor > 1 && unit == "s") chosen = &prefixes[3];  // nobody counts in kiloseconds
  // Lengths and times a little below one read better undivided: 0.5 m, 0.25 s.
  if (chosen->factor == 1e-3 && size >= 0.1 && (unit == "m" || unit == "s")) chosen = &prefixes[3];
  if (chosen == &prefixes.back() && size < 1e-12) return for_people(shortest(value, digits)) + " " + text;
  return for_people(shortest(value / chosen->factor, digits)) + " " + std::string(chosen->text) + text;
}

std::optional<double> parse_quantity(std::string_view text, std::string_view unit) {
  text = trimmed(text);
  if (const auto value = number_in(text)) return value;
  std::string_view rest = text;
  const std::string pretty = pretty_unit(unit);
  for (const std::string_view spelling : {unit, std::string_view(pretty)}) {
    if (spelling.empty() || !rest.ends_with(spelling)) continue;
    rest.remove_suffix(spelling.size());
    if (const auto value = number_in(trimmed(rest))) return value;
  }
  if (!takes_prefix(unit)) return std::nullopt;
  for (const Prefix& p : prefixes) {
    const std::string_view mark = p.text;
    const bool ascii_micro = p.factor == 1e-6 && rest.ends_with("u");
    if (mark.empty() || !(rest.ends_with(mark) || ascii_micro)) continue;
    if (const auto value = number_in(trimmed(rest.substr(0, rest.size() - (ascii_micro ? 1 : mark.size())))))
      return *value * p.factor;
  }
  return std::nullopt;
}

}  // namespace pf::app
