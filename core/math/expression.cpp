#include "core/math/expression.hpp"

#include <algorithm>
#include <array>

#include "core/math/expression_program.hpp"

namespace pf {
namespace {

constexpr std::size_t small_stack = 8;   ///< slots: enough for nearly every expression that people type
constexpr std::size_t batch_stack = 16;  ///< slots of a batch; deeper programs run value by value
constexpr std::size_t batch_width = 64;  ///< values that one instruction handles

template <std::size_t Slots, class T>
T run(const Program& program, std::span<const T> variables) {
  std::array<T, Slots> stack;
  T* end = stack.data();  // of the values on the stack
  for (const Instruction& instruction : program.code) {
    switch (operands(instruction.op)) {
      case 0:
        *end++ = instruction.op == Op::constant ? T(instruction.value)
                                                : variables[static_cast<std::size_t>(instruction.index)];
        break;
      case 1:
        end[-1] = apply(instruction, end[-1]);
        break;
      case 2:
        --end;
        end[-1] = apply(instruction.op, end[-1], end[0]);
        break;
      default:
        end -= 2;
        end[-1] = truth(end[-1]) ? end[0] : end[1];
    }
  }
  return end[-1];
}

template <class T>
T run(const Program& program, std::span<const T> variables) {
  if (program.stack <= small_stack) return run<small_stack>(program, variables);
  return run<max_stack>(program, variables);
}

using Row = std::array<double, batch_width>;

/// At most batch_width values from number `begin` on. A variable of one value is the same for all.
void run_batch(const Program& program, const Expression::Columns& variables, std::size_t begin,
               std::span<double> result) {
  std::array<Row, batch_stack> stack;
  Row* end = stack.data();
  const std::size_t n = result.size();
  for (const Instruction& instruction : program.code) {
    if (instruction.op == Op::constant) {
      std::fill_n((end++)->begin(), n, instruction.value);
    } else if (instruction.op == Op::variable) {
      const std::span<const double> column = variables[static_cast<std::size_t>(instruction.index)];
      Row& row = *end++;
      if (column.size() == 1) {
        std::fill_n(row.begin(), n, column[0]);
      } else {
        std::copy_n(column.begin() + static_cast<std::ptrdiff_t>(begin), n, row.begin());
      }
    } else if (operands(instruction.op) == 1) {
      with_unary(instruction, [&a = end[-1], n](auto f) {
        for (std::size_t i = 0; i < n; ++i) a[i] = f(a[i]);
      });
    } else if (operands(instruction.op) == 2) {
      --end;
      with_binary(instruction.op, [&a = end[-1], &b = end[0], n](auto f) {
        for (std::size_t i = 0; i < n; ++i) a[i] = f(a[i], b[i]);
      });
    } else {
      end -= 2;
      for (std::size_t i = 0; i < n; ++i) end[-1][i] = truth(end[-1][i]) ? end[0][i] : end[1][i];
    }
  }
  std::copy_n(end[-1].begin(), n, result.begin());
}

}  // namespace

Expression::Expression() : Expression(0.0) {}

Expression::Expression(double value)
    : program_(std::make_shared<const Program>(Program{{{Op::constant, 0, value}}, 1, 0})) {}

bool Expression::is_constant() const {
  return program_->code.size() == 1 && program_->code[0].op == Op::constant;
}

bool Expression::depends_on(Variable v) const {
  return (program_->variables >> v & 1u) != 0;
}

double Expression::operator()(std::span<const double> v) const {
  return run(*program_, v);
}

Jet2 Expression::operator()(std::span<const Jet2> v) const {
  return run(*program_, v);
}

void Expression::evaluate(const Columns& variables, std::span<double> result) const {
  if (is_constant()) {
    std::ranges::fill(result, program_->code[0].value);
    return;
  }
  if (program_->stack <= batch_stack) {
    for (std::size_t begin = 0; begin < result.size(); begin += batch_width)
      run_batch(*program_, variables, begin, result.subspan(begin, std::min(batch_width, result.size() - begin)));
    return;
  }
  std::array<double, variable_count> v{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t k = 0; k < v.size(); ++k)
      if (!variables[k].empty()) v[k] = variables[k][variables[k].size() == 1 ? 0 : i];
    result[i] = (*this)(std::span<const double>(v));
  }
}

}  // namespace pf
