// What the parser builds: operations as nodes, equal ones made once, and the program that evaluates them.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/math/expression_program.hpp"

namespace pf {

/// A node's operands are older than itself. An operation on constants becomes a constant at once, and what is typed
/// twice is evaluated once.
class ExpressionGraph {
 public:
  using Id = std::int32_t;

  Id constant(double value) { return intern({{Op::constant, 0, value}, {}}); }
  Id variable(int v) { return intern({{Op::variable, v}, {}}); }
  Id unary(Op op, Id a);
  Id binary(Op op, Id a, Id b);
  Id select(Id condition, Id yes, Id no);

  /// Evaluates node `root`.
  Program program(Id root) const;

 private:
  struct Node {
    Instruction instruction;
    std::array<Id, 3> operand;  ///< as many as the operation has, then 0
    bool operator==(const Node& other) const;
  };
  struct Hash {
    std::size_t operator()(const Node& node) const;
  };

  Id intern(const Node& node);
  const double* constant_value(Id id) const;
  /// How often each node is used by those that `root` needs.
  std::vector<int> uses(Id root) const;

  std::vector<Node> nodes_;
  std::unordered_map<Node, Id, Hash> known_;
};

}  // namespace pf
