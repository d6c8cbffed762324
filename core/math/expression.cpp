#include "core/math/expression.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <type_traits>

#include "core/math/expression_program.hpp"

namespace pf {
namespace {

constexpr std::size_t batch_slots = 24;  ///< of a batch; a program that needs more runs value by value
constexpr std::size_t batch_width = 64;  ///< values that one instruction handles

/// Room for the saved values and the stack above them; none is made before it is needed.
template <class T>
union Slots {
  Slots() {}   // NOLINT(modernize-use-equals-default): that of a union would be deleted
  ~Slots() {}  // NOLINT(modernize-use-equals-default)
  T at[max_saved + max_stack];
};

template <class T>
T run(const Program& program, std::span<const T> variables) {
  static_assert(std::is_trivially_destructible_v<T>);
  Slots<T> slots;
  T* const kept = slots.at;
  T* end = slots.at + program.saved;  // of the stack
  for (const Instruction& instruction : program.code) {
    switch (operands(instruction.op)) {
      case 0: {
        const auto index = static_cast<std::size_t>(instruction.index);
        if (instruction.op == Op::constant) {
          std::construct_at(end++, instruction.value);
        } else if (instruction.op == Op::variable) {
          std::construct_at(end++, variables[index]);
        } else if (instruction.op == Op::load) {
          std::construct_at(end++, kept[index]);
        } else {
          std::construct_at(kept + index, end[-1]);
        }
        break;
      }
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

using Row = std::array<double, batch_width>;

/// At most batch_width values from number `begin` on. A variable of one value is the same for all.
void run_batch(const Program& program, const Expression::Columns& variables, std::size_t begin,
               std::span<double> result) {
  std::array<Row, batch_slots> slots;
  Row* const kept = slots.data();
  Row* end = kept + program.saved;  // of the stack
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
    } else if (instruction.op == Op::load) {
      *end++ = kept[instruction.index];
    } else if (instruction.op == Op::save) {
      kept[instruction.index] = end[-1];
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
    : program_([value] {
        auto program = std::make_shared<Program>();
        program->add({Op::constant, 0, value});
        return program;
      }()) {}

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
  if (program_->saved + program_->stack <= batch_slots) {
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
