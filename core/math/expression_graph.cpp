#include "core/math/expression_graph.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pf {
namespace {

bool is_small_integer(double v) {
  return std::abs(v) <= 64 && v == std::trunc(v);
}

}  // namespace

// Constants by their bits: -0 is not 0, and NaN equals itself.
bool ExpressionGraph::Node::operator==(const Node& other) const {
  return instruction.op == other.instruction.op && instruction.index == other.instruction.index &&
         std::bit_cast<std::uint64_t>(instruction.value) == std::bit_cast<std::uint64_t>(other.instruction.value) &&
         operand == other.operand;
}

std::size_t ExpressionGraph::Hash::operator()(const Node& node) const {
  std::uint64_t h = static_cast<std::uint64_t>(node.instruction.op);
  const auto add = [&h](std::uint64_t v) { h = (h ^ v) * 0x9e3779b97f4a7c15u, h ^= h >> 29; };
  add(static_cast<std::uint64_t>(node.instruction.index));
  add(std::bit_cast<std::uint64_t>(node.instruction.value));
  for (const Id id : node.operand) add(static_cast<std::uint64_t>(id));
  return static_cast<std::size_t>(h);
}

ExpressionGraph::Id ExpressionGraph::intern(const Node& node) {
  const auto [at, is_new] = known_.try_emplace(node, static_cast<Id>(nodes_.size()));
  if (is_new) nodes_.push_back(node);
  return at->second;
}

const double* ExpressionGraph::constant_value(Id id) const {
  const Instruction& instruction = nodes_[static_cast<std::size_t>(id)].instruction;
  return instruction.op == Op::constant ? &instruction.value : nullptr;
}

ExpressionGraph::Id ExpressionGraph::unary(Op op, Id a) {
  const Instruction instruction{op};
  if (const double* value = constant_value(a)) return constant(apply(instruction, *value));
  return intern({instruction, {a}});
}

ExpressionGraph::Id ExpressionGraph::binary(Op op, Id a, Id b) {
  const double *first = constant_value(a), *second = constant_value(b);
  if (first && second) return constant(apply(op, *first, *second));
  if (op == Op::power && second && is_small_integer(*second))
    return intern({{Op::power_integer, static_cast<std::int32_t>(*second)}, {a}});
  return intern({{op}, {a, b}});
}

ExpressionGraph::Id ExpressionGraph::select(Id condition, Id yes, Id no) {
  if (const double* value = constant_value(condition)) return truth(*value) ? yes : no;
  return intern({{Op::select}, {condition, yes, no}});
}

std::vector<int> ExpressionGraph::uses(Id root) const {
  std::vector<int> count(static_cast<std::size_t>(root) + 1, 0);
  count.back() = 1;
  for (std::size_t i = count.size(); i-- > 0;) {  // users come after what they use
    if (count[i] == 0) continue;
    const Node& node = nodes_[i];
    for (int k = 0; k < operands(node.instruction.op); ++k) ++count[static_cast<std::size_t>(node.operand[k])];
  }
  return count;
}

Program ExpressionGraph::program(Id root) const {
  Program program;
  const std::vector<int> count = uses(root);
  constexpr std::int32_t unsaved = -1;
  std::vector<std::int32_t> saved(count.size(), unsaved);  // where a node's value is kept once it is known
  // Depth first, without recursion: a sum of many terms is as deep as it is long.
  struct Visit {
    Id id;
    int next;  ///< operand to visit
  };
  std::vector<Visit> path = {{root, 0}};
  while (!path.empty()) {
    Visit& visit = path.back();
    const auto at = static_cast<std::size_t>(visit.id);
    const Node& node = nodes_[at];
    const int n = operands(node.instruction.op);
    if (visit.next == 0 && saved[at] != unsaved) {
      program.add({Op::load, saved[at]});
    } else if (visit.next < n) {
      path.push_back({node.operand[visit.next++], 0});
      continue;
    } else {
      program.add(node.instruction);
      if (n > 0 && count[at] > 1 && program.saved < max_saved) {
        saved[at] = static_cast<std::int32_t>(program.saved++);
        program.add({Op::save, saved[at]});
      }
    }
    path.pop_back();
  }
  return program;
}

}  // namespace pf
