#include "core/math/expression_names.hpp"

#include <algorithm>

#include "core/params/nearest.hpp"

namespace pf {
namespace {

constexpr ExpressionFunction functions[] = {
    {"sin", Op::sin, 1},           {"cos", Op::cos, 1},   {"tan", Op::tan, 1},     {"asin", Op::asin, 1},
    {"acos", Op::acos, 1},         {"atan", Op::atan, 1}, {"atan2", Op::atan2, 2}, {"sinh", Op::sinh, 1},
    {"cosh", Op::cosh, 1},         {"tanh", Op::tanh, 1}, {"exp", Op::exp, 1},     {"ln", Op::ln, 1},
    {"log10", Op::log10, 1},       {"sqrt", Op::sqrt, 1}, {"abs", Op::abs, 1},     {"min", Op::minimum, 2, true},
    {"max", Op::maximum, 2, true},
};

bool equal_but_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace

std::span<const ExpressionFunction> expression_functions() {
  return functions;
}

const ExpressionFunction* find_expression_function(std::string_view name) {
  const auto found = std::ranges::find(functions, name, &ExpressionFunction::name);
  return found == std::end(functions) ? nullptr : found;
}

std::string suggestion(std::string_view unknown, const Constants& constants, VariableMask allowed) {
  if (unknown.size() > 64) return "";
  if (unknown == "log") return "; did you mean 'ln' or 'log10'?";
  if (unknown == "pow") return "; write a^b for powers";
  std::vector<std::string> known;
  for (const auto& [name, value] : constants) known.push_back(name);
  for (const ExpressionFunction& function : functions) known.emplace_back(function.name);
  known.emplace_back("pi");
  for (int v = 0; v < variable_count; ++v)
    if (allowed >> v & 1u) known.emplace_back(all_variables[v]);
  const auto same = std::ranges::find_if(known, [&](const auto& name) { return equal_but_case(name, unknown); });
  // One or two letters are near to everything.
  const std::string best = same != known.end() ? *same : unknown.size() < 3 ? "" : nearest_name(unknown, known);
  return best.empty() ? "" : "; did you mean '" + best + "'?";
}

std::string variable_list(VariableMask allowed) {
  std::string list;
  for (int v = 0; v < variable_count; ++v)
    if (allowed >> v & 1u) list.append(list.empty() ? "" : " ").append(all_variables[v]);
  return list.empty() ? "none" : list;
}

}  // namespace pf
