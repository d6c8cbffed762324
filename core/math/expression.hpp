// Expressions typed by the user (INTERFACE fine print 1): compiled once, evaluated on doubles, on jets, in batches.
//
// From the loosest to the tightest: ?: | || | && | == != | < > <= >= | + - | * / | unary - + ! | ^ (from the right,
// so -X^2 is -(X^2) and 2^-1 is allowed). Comparisons give 0 or 1 and do not chain; any value but 0 is true. Both
// sides of ?:, && and || are evaluated; NaN on the side that is not taken does no harm.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/math/jet.hpp"

namespace pf {

/// A text that is not an expression: what is wrong, at which character (0-based), what is allowed.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(const std::string& what, std::size_t position) : std::runtime_error(what), position_(position) {}
  std::size_t position() const { return position_; }

 private:
  std::size_t position_;
};

using Constants = std::vector<std::pair<std::string, double>>;

/// The variables an expression may use, in the order of its arguments.
inline constexpr std::string_view all_variables[] = {"X", "Y", "Z", "x", "y", "z", "t"};
enum Variable : int { var_X, var_Y, var_Z, var_x, var_y, var_z, var_t, variable_count };
using VariableMask = unsigned;  ///< bit v set: variable v is allowed
inline constexpr VariableMask mask_none = 0, mask_reference = 0b0000111, mask_time = 0b1000000,
                              mask_reference_time = 0b1000111, mask_all = 0b1111111;

struct Program;

/// Immutable; copies share the program; evaluation is thread-safe and allocates nothing.
class Expression {
 public:
  /// The constant 0.
  Expression();
  explicit Expression(double value);
  /// Throws ExpressionError: syntax, unknown name (the nearest known one is suggested), a variable outside
  /// `allowed`, too long (> 64 KiB) or too deep (> 200 levels). The language's own names win over `constants`.
  static Expression compile(std::string_view text, const Constants& constants, VariableMask allowed);

  /// No variable is left after folding; its value is that for any arguments, an empty span too.
  bool is_constant() const;
  bool depends_on(Variable v) const;
  /// `v` in the order of all_variables; variable_count values.
  double operator()(std::span<const double> v) const;
  /// Value and exact first and second derivatives with respect to whatever the jets carry.
  Jet2 operator()(std::span<const Jet2> v) const;

  /// A column of values a variable, in the order of all_variables: as many as results, or one for all, or none
  /// for a variable that the expression does not use.
  using Columns = std::array<std::span<const double>, variable_count>;
  /// result[i] = the value at the i-th entry of every column; the same bits as operator().
  void evaluate(const Columns& variables, std::span<double> result) const;

 private:
  std::shared_ptr<const Program> program_;
};

}  // namespace pf
