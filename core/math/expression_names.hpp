// The names that expressions know.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/math/expression.hpp"
#include "core/math/expression_program.hpp"

namespace pf {

struct ExpressionFunction {
  std::string_view name;
  Op op;
  int arguments;  ///< 1 or 2; with `more`, the least number of them
  bool more = false;
};

std::span<const ExpressionFunction> expression_functions();
const ExpressionFunction* find_expression_function(std::string_view name);

/// "; did you mean 'sin'?" for the nearest known name, "" when none is near.
std::string suggestion(std::string_view unknown, const Constants& constants, VariableMask allowed);
/// The allowed variables as text: "X Y t", or "none".
std::string variable_list(VariableMask allowed);

}  // namespace pf
