// Text -> postfix program, by precedence climbing, constants folded as they appear.
#include <cmath>
#include <limits>
#include <numbers>

#include "core/math/expression.hpp"
#include "core/math/expression_lexer.hpp"
#include "core/math/expression_names.hpp"
#include "core/math/expression_program.hpp"

namespace pf {
namespace {

constexpr std::size_t max_length = 64 * 1024;
constexpr int max_depth = 200;

struct BinaryOperator {
  std::string_view symbol;
  Op op;
  int precedence;
  bool chains;  ///< a op b op c is allowed; not for comparisons: 0 < X < 1 would not mean what it says
};
constexpr int comparison = 3, equality = 2, lowest = 0;
constexpr BinaryOperator binary_operators[] = {
    {"||", Op::logical_or, 0, true},
    {"&&", Op::logical_and, 1, true},
    {"==", Op::equal, equality, false},
    {"!=", Op::not_equal, equality, false},
    {"<", Op::less, comparison, false},
    {">", Op::greater, comparison, false},
    {"<=", Op::less_equal, comparison, false},
    {">=", Op::greater_equal, comparison, false},
    {"+", Op::add, 4, true},
    {"-", Op::subtract, 4, true},
    {"*", Op::multiply, 5, true},
    {"/", Op::divide, 5, true},
};

const BinaryOperator* binary_operator(const Token& token) {
  for (const BinaryOperator& candidate : binary_operators)
    if (token.is(candidate.symbol)) return &candidate;
  return nullptr;
}

/// Appends instructions; an operation on constants becomes a constant at once. In postfix the last operand is
/// the last instruction when that is a constant, so folding needs to look no further.
class Emitter {
 public:
  void constant(double value) { code_.push_back({Op::constant, 0, value}); }
  void variable(int v) { code_.push_back({Op::variable, v}); }

  void unary(Op op, int index = 0) {
    const Instruction instruction{op, index};
    if (constant_at(1)) {
      code_.back().value = apply(instruction, code_.back().value);
    } else {
      code_.push_back(instruction);
    }
  }

  void binary(Op op) {
    if (constant_at(1) && constant_at(2)) {
      const double b = code_.back().value;
      code_.pop_back();
      code_.back().value = apply(op, code_.back().value, b);
    } else if (op == Op::power && constant_at(1) && is_small_integer(code_.back().value)) {
      const int exponent = static_cast<int>(code_.back().value);
      code_.pop_back();
      code_.push_back({Op::power_integer, exponent});
    } else {
      code_.push_back({op});
    }
  }

  std::size_t size() const { return code_.size(); }

  /// The code holds, from `condition` on, the three operands of ?: of which the later begin at `yes`, `no`.
  void select(std::size_t condition, std::size_t yes, std::size_t no) {
    const auto at = [&](std::size_t k) { return code_.begin() + static_cast<std::ptrdiff_t>(k); };
    if (yes - condition == 1 && code_[condition].op == Op::constant) {
      const bool taken = truth(code_[condition].value);
      if (taken) {
        code_.erase(at(no), code_.end());
      } else {
        code_.erase(at(yes), at(no));
      }
      code_.erase(at(condition));
    } else {
      code_.push_back({Op::select});
    }
  }

  std::vector<Instruction> take() { return std::move(code_); }

 private:
  bool constant_at(std::size_t from_end) const {
    return code_.size() >= from_end && code_[code_.size() - from_end].op == Op::constant;
  }
  static bool is_small_integer(double v) { return std::abs(v) <= 64 && v == std::trunc(v); }

  std::vector<Instruction> code_;
};

class Parser {
 public:
  Parser(std::string_view text, const Constants& constants, VariableMask allowed)
      : lexer_(text), constants_(constants), allowed_(allowed) {
    advance();
  }

  std::vector<Instruction> parse() {
    if (token_.kind == Token::Kind::end) fail("the expression is empty");
    ternary();
    if (token_.kind != Token::Kind::end) unexpected("an operator");
    return emit_.take();
  }

 private:
  /// Counts nesting for as long as it lives, so that hostile text cannot exhaust the stack.
  class Level {
   public:
    explicit Level(Parser& parser) : depth_(parser.depth_) {
      if (++depth_ > max_depth) parser.fail("nested too deep (more than " + std::to_string(max_depth) + " levels)");
    }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    int& depth_;
  };

  [[noreturn]] void fail(const std::string& message) const { throw ExpressionError(message, token_.position); }
  [[noreturn]] void unexpected(const std::string& expected) const {
    const bool end = token_.kind == Token::Kind::end;
    std::string message = end ? "the expression ends" : "found '" + std::string(token_.text.substr(0, 32)) + "'";
    message += " where " + expected + " should be";
    const bool operand = token_.kind == Token::Kind::number || token_.kind == Token::Kind::name || token_.is("(");
    if (expected == "an operator" && operand) message += "; write a*b for products";
    if (expected == "a value" && token_.is("*")) message += "; write a^b for powers";
    fail(message);
  }
  void advance() { token_ = lexer_.next(); }
  void expect(std::string_view symbol) {
    if (!token_.is(symbol)) unexpected("'" + std::string(symbol) + "'");
    advance();
  }

  void ternary() {
    const Level level(*this);
    const std::size_t condition = emit_.size();
    binary(lowest);
    if (!token_.is("?")) return;
    advance();
    const std::size_t yes = emit_.size();
    ternary();
    expect(":");
    const std::size_t no = emit_.size();
    ternary();
    emit_.select(condition, yes, no);
  }

  /// Operators of at least `precedence`; all of them group from the left.
  void binary(int precedence) {
    unary();
    const BinaryOperator* last = nullptr;
    for (const BinaryOperator* found = binary_operator(token_); found && found->precedence >= precedence;
         found = binary_operator(token_)) {
      if (last && last->precedence == found->precedence && !found->chains)
        fail("comparisons do not chain; write a " + std::string(last->symbol) + " b && b " +
             std::string(found->symbol) + " c");
      advance();
      binary(found->precedence + 1);
      emit_.binary(found->op);
      last = found;
    }
  }

  void unary() {
    const bool negate = token_.is("-"), invert = token_.is("!");
    if (negate || invert || token_.is("+")) {
      advance();
      deeper_unary();
      if (negate) emit_.unary(Op::negate);
      if (invert) emit_.unary(Op::logical_not);
      return;
    }
    primary();
    if (!token_.is("^")) return;
    advance();
    deeper_unary();  // groups from the right: a^b^c = a^(b^c), and a^-b
    emit_.binary(Op::power);
  }
  void deeper_unary() {
    const Level level(*this);
    unary();
  }

  void primary() {
    if (token_.kind == Token::Kind::number) {
      emit_.constant(token_.value);
      advance();
    } else if (token_.kind == Token::Kind::name) {
      name();
    } else if (token_.is("(")) {
      advance();
      ternary();
      expect(")");
    } else {
      unexpected("a value");
    }
  }

  void name() {
    const Token name = token_;
    if (const ExpressionFunction* function = find_expression_function(name.text)) {
      advance();
      call(*function, name);
      return;
    }
    if (name.text == "pi") {
      emit_.constant(std::numbers::pi);
    } else if (const int v = variable(name.text); v < variable_count) {
      if ((allowed_ >> v & 1u) == 0)
        fail("the variable '" + std::string(name.text) +
             "' is not available here; available: " + variable_list(allowed_));
      emit_.variable(v);
    } else {
      emit_.constant(user_constant(name.text));
    }
    advance();
    if (token_.is("("))
      fail("'" + std::string(name.text.substr(0, 64)) + "' is not a function; write a*b for products");
  }

  static int variable(std::string_view name) {
    int v = 0;
    while (v < variable_count && all_variables[v] != name) ++v;
    return v;
  }

  double user_constant(std::string_view name) const {
    for (const auto& [known, value] : constants_)
      if (known == name) return value;
    fail("unknown name '" + std::string(name.substr(0, 64)) + "'" + suggestion(name, constants_, allowed_));
  }

  void call(const ExpressionFunction& function, const Token& name) {
    if (!token_.is("(")) unexpected("'(' after the function " + std::string(function.name));
    advance();
    int arguments = 0;
    do {
      if (arguments > 0) advance();
      ternary();
      ++arguments;
      // min(a, b, c) is min(min(a, b), c): n arguments need no longer stack than two.
      if (function.arguments == 2 && (arguments == 2 || (function.more && arguments > 2))) emit_.binary(function.op);
    } while (token_.is(",") && (function.more || arguments <= function.arguments));
    expect(")");
    if (arguments != function.arguments && !(function.more && arguments > function.arguments))
      throw ExpressionError(std::string(function.name) + " takes " + (function.more ? "at least " : "") +
                                std::to_string(function.arguments) + " argument" +
                                (function.arguments == 1 ? "" : "s") + ", not " + std::to_string(arguments),
                            name.position);
    if (function.arguments == 1) emit_.unary(function.op);
  }

  Lexer lexer_;
  const Constants& constants_;
  VariableMask allowed_;
  Token token_;
  Emitter emit_;
  int depth_ = 0;
};

/// Slots of the stack that the program needs, and the variables it uses.
void measure(Program& program) {
  int depth = 0, deepest = 0;
  for (const Instruction& instruction : program.code) {
    depth += 1 - operands(instruction.op);
    deepest = std::max(deepest, depth);
    if (instruction.op == Op::variable) program.variables |= 1u << instruction.index;
  }
  program.stack = static_cast<std::size_t>(deepest);
}

}  // namespace

Expression Expression::compile(std::string_view text, const Constants& constants, VariableMask allowed) {
  if (text.size() > max_length)
    throw ExpressionError("longer than " + std::to_string(max_length) + " characters", max_length);
  Program program;
  program.code = Parser(text, constants, allowed).parse();
  measure(program);
  if (program.stack > max_stack) throw ExpressionError("too deep: it holds too many unfinished operations", 0);
  Expression expression;
  expression.program_ = std::make_shared<const Program>(std::move(program));
  return expression;
}

}  // namespace pf
