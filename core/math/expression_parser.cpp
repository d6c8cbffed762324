// Text -> graph, by precedence climbing.
#include <numbers>
#include <utility>

#include "core/math/expression.hpp"
#include "core/math/expression_graph.hpp"
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

class Parser {
 public:
  Parser(std::string_view text, const Constants& constants, VariableMask allowed)
      : lexer_(text), constants_(constants), allowed_(allowed) {
    advance();
  }

  Program parse() {
    if (token_.kind == Token::Kind::end) fail("the expression is empty");
    const Id root = ternary();
    if (token_.kind != Token::Kind::end) unexpected("an operator");
    return graph_.program(root);
  }

 private:
  using Id = ExpressionGraph::Id;

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

  Id ternary() {
    const Level level(*this);
    const Id condition = binary(lowest);
    if (!token_.is("?")) return condition;
    advance();
    const Id yes = ternary();
    expect(":");
    return graph_.select(condition, yes, ternary());
  }

  /// Operators of at least `precedence`; all of them group from the left.
  Id binary(int precedence) {
    Id left = unary();
    const BinaryOperator* last = nullptr;
    for (const BinaryOperator* found = binary_operator(token_); found && found->precedence >= precedence;
         found = binary_operator(token_)) {
      if (last && last->precedence == found->precedence && !found->chains)
        fail("comparisons do not chain; write a " + std::string(last->symbol) + " b && b " +
             std::string(found->symbol) + " c");
      advance();
      left = graph_.binary(found->op, left, binary(found->precedence + 1));
      last = found;
    }
    return left;
  }

  Id unary() {
    for (const auto& [symbol, op] : {std::pair{"-", Op::negate}, std::pair{"!", Op::logical_not}}) {
      if (!token_.is(symbol)) continue;
      advance();
      return graph_.unary(op, deeper_unary());
    }
    if (token_.is("+")) {
      advance();
      return deeper_unary();
    }
    const Id base = primary();
    if (!token_.is("^")) return base;
    advance();
    return graph_.binary(Op::power, base, deeper_unary());  // from the right: a^b^c = a^(b^c), and a^-b
  }
  Id deeper_unary() {
    const Level level(*this);
    return unary();
  }

  Id primary() {
    if (token_.kind == Token::Kind::number) {
      const double value = token_.value;
      advance();
      return graph_.constant(value);
    }
    if (token_.kind == Token::Kind::name) return name();
    if (!token_.is("(")) unexpected("a value");
    advance();
    const Id inner = ternary();
    expect(")");
    return inner;
  }

  Id name() {
    const Token name = token_;
    if (const ExpressionFunction* function = find_expression_function(name.text)) {
      advance();
      return call(*function, name);
    }
    const Id id = value_of_name(name.text);
    advance();
    if (token_.is("("))
      fail("'" + std::string(name.text.substr(0, 64)) + "' is not a function; write a*b for products");
    return id;
  }

  Id value_of_name(std::string_view name) {
    if (name == "pi") return graph_.constant(std::numbers::pi);
    const int v = variable(name);
    if (v == variable_count) return graph_.constant(user_constant(name));
    if ((allowed_ >> v & 1u) == 0)
      fail("the variable '" + std::string(name) + "' is not available here; available: " + variable_list(allowed_));
    return graph_.variable(v);
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

  Id call(const ExpressionFunction& function, const Token& name) {
    if (!token_.is("(")) unexpected("'(' after the function " + std::string(function.name));
    advance();
    Id first = ternary(), result = first;
    int arguments = 1;
    for (; token_.is(",") && (function.more || arguments <= function.arguments); ++arguments) {
      advance();
      // min(a, b, c) is min(min(a, b), c).
      const Id next = ternary();
      if (function.arguments == 2) result = graph_.binary(function.op, result, next);
    }
    expect(")");
    if (arguments != function.arguments && !(function.more && arguments > function.arguments))
      throw ExpressionError(std::string(function.name) + " takes " + (function.more ? "at least " : "") +
                                std::to_string(function.arguments) + " argument" +
                                (function.arguments == 1 ? "" : "s") + ", not " + std::to_string(arguments),
                            name.position);
    return function.arguments == 1 ? graph_.unary(function.op, first) : result;
  }

  Lexer lexer_;
  const Constants& constants_;
  VariableMask allowed_;
  Token token_;
  ExpressionGraph graph_;
  int depth_ = 0;
};

}  // namespace

Expression Expression::compile(std::string_view text, const Constants& constants, VariableMask allowed) {
  if (text.size() > max_length)
    throw ExpressionError("longer than " + std::to_string(max_length) + " characters", max_length);
  Program program = Parser(text, constants, allowed).parse();
  if (program.stack > max_stack) throw ExpressionError("too deep: it holds too many unfinished operations", 0);
  Expression expression;
  expression.program_ = std::make_shared<const Program>(std::move(program));
  return expression;
}

}  // namespace pf
