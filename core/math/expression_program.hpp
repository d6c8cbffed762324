// What a compiled expression is: a postfix program over a small stack, with a place for values that are used again;
// and what each operation does to values.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "core/math/jet.hpp"

namespace pf {

enum class Op : std::uint8_t {
  // leaves
  constant,
  variable,
  load,  // the value kept under an index
  save,  // not an operation on values: keeps the newest value under an index, and leaves it where it is
  // one operand
  negate,
  logical_not,
  power_integer,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sinh,
  cosh,
  tanh,
  exp,
  ln,
  log10,
  sqrt,
  abs,
  // two operands
  add,
  subtract,
  multiply,
  divide,
  power,
  atan2,
  minimum,
  maximum,
  less,
  greater,
  less_equal,
  greater_equal,
  equal,
  not_equal,
  logical_and,
  logical_or,
  // three operands: condition, value if true, value if false
  select,
};

struct Instruction {
  Op op;
  std::int32_t index = 0;  ///< variable, load, save: which; power_integer: the exponent
  double value = 0;        ///< constant
};

constexpr int operands(Op op) {
  if (op <= Op::save) return 0;
  if (op <= Op::abs) return 1;
  return op == Op::select ? 3 : 2;
}

inline constexpr std::size_t max_stack = 512;  ///< no program needs more: compile() refuses deeper ones
inline constexpr std::size_t max_saved = 32;   ///< values kept for later; further ones are computed again

struct Program {
  std::vector<Instruction> code;
  std::size_t depth = 0;   ///< values on the stack at the end of `code`: 1 for a complete program
  std::size_t stack = 0;   ///< values that evaluation needs there at most
  std::size_t saved = 0;   ///< values that evaluation keeps
  unsigned variables = 0;  ///< bit v set: variable v is used

  void add(const Instruction& instruction) {
    code.push_back(instruction);
    if (instruction.op == Op::variable) variables |= 1u << instruction.index;
    if (instruction.op == Op::save) return;
    depth = depth + 1 - static_cast<std::size_t>(operands(instruction.op));
    stack = depth > stack ? depth : stack;
  }
};

inline double value_of(double a) {
  return a;
}
inline double value_of(const Jet2& a) {
  return a.value;
}
inline bool truth(double a) {
  return a != 0;
}
inline bool truth(const Jet2& a) {
  return a.value != 0;
}

/// Calls visit(f), f the function of one value that `op` stands for, generic in double and Jet2. So one switch
/// serves evaluation on numbers, on jets and on batches.
template <class Visit>
auto with_unary(const Instruction& instruction, Visit&& visit) {
  // Those for doubles; those for jets are found by their argument.
  using std::abs, std::acos, std::asin, std::atan, std::cos, std::cosh, std::exp, std::log, std::log10, std::sin,
      std::sinh, std::sqrt, std::tan, std::tanh;
  switch (instruction.op) {
    case Op::logical_not:
      return visit([](const auto& a) { return truth(a) ? 0.0 : 1.0; });
    case Op::power_integer:
      if (instruction.index == 2) return visit([](const auto& a) { return a * a; });
      return visit([n = instruction.index](const auto& a) { return integer_power(a, n); });
    case Op::sin:
      return visit([](const auto& a) { return sin(a); });
    case Op::cos:
      return visit([](const auto& a) { return cos(a); });
    case Op::tan:
      return visit([](const auto& a) { return tan(a); });
    case Op::asin:
      return visit([](const auto& a) { return asin(a); });
    case Op::acos:
      return visit([](const auto& a) { return acos(a); });
    case Op::atan:
      return visit([](const auto& a) { return atan(a); });
    case Op::sinh:
      return visit([](const auto& a) { return sinh(a); });
    case Op::cosh:
      return visit([](const auto& a) { return cosh(a); });
    case Op::tanh:
      return visit([](const auto& a) { return tanh(a); });
    case Op::exp:
      return visit([](const auto& a) { return exp(a); });
    case Op::ln:
      return visit([](const auto& a) { return log(a); });
    case Op::log10:
      return visit([](const auto& a) { return log10(a); });
    case Op::sqrt:
      return visit([](const auto& a) { return sqrt(a); });
    case Op::abs:
      return visit([](const auto& a) { return abs(a); });
    default:
      return visit([](const auto& a) { return -a; });  // negate
  }
}

/// The same for functions of two values.
template <class Visit>
auto with_binary(Op op, Visit&& visit) {
  using std::atan2, std::pow;
  switch (op) {
    case Op::subtract:
      return visit([](const auto& a, const auto& b) { return a - b; });
    case Op::multiply:
      return visit([](const auto& a, const auto& b) { return a * b; });
    case Op::divide:
      return visit([](const auto& a, const auto& b) { return a / b; });
    case Op::power:
      return visit([](const auto& a, const auto& b) { return pow(a, b); });
    case Op::atan2:
      return visit([](const auto& a, const auto& b) { return atan2(a, b); });
    case Op::minimum:
      return visit([](const auto& a, const auto& b) { return smaller(a, b); });
    case Op::maximum:
      return visit([](const auto& a, const auto& b) { return larger(a, b); });
    case Op::less:
      return visit([](const auto& a, const auto& b) { return value_of(a) < value_of(b) ? 1.0 : 0.0; });
    case Op::greater:
      return visit([](const auto& a, const auto& b) { return value_of(a) > value_of(b) ? 1.0 : 0.0; });
    case Op::less_equal:
      return visit([](const auto& a, const auto& b) { return value_of(a) <= value_of(b) ? 1.0 : 0.0; });
    case Op::greater_equal:
      return visit([](const auto& a, const auto& b) { return value_of(a) >= value_of(b) ? 1.0 : 0.0; });
    case Op::equal:
      return visit([](const auto& a, const auto& b) { return value_of(a) == value_of(b) ? 1.0 : 0.0; });
    case Op::not_equal:
      return visit([](const auto& a, const auto& b) { return value_of(a) != value_of(b) ? 1.0 : 0.0; });
    case Op::logical_and:
      return visit([](const auto& a, const auto& b) { return truth(a) && truth(b) ? 1.0 : 0.0; });
    case Op::logical_or:
      return visit([](const auto& a, const auto& b) { return truth(a) || truth(b) ? 1.0 : 0.0; });
    default:
      return visit([](const auto& a, const auto& b) { return a + b; });  // add
  }
}

template <class T>
T apply(const Instruction& instruction, const T& a) {
  return with_unary(instruction, [&](auto f) { return T(f(a)); });
}
template <class T>
T apply(Op op, const T& a, const T& b) {
  return with_binary(op, [&](auto f) { return T(f(a, b)); });
}

}  // namespace pf
