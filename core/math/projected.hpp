// Where a Hessian is to be replaced by a positive semi-definite substitute.
#pragma once

#include <cstddef>
#include <span>

namespace pf {

/// The parts of an energy that meet a marked node are projected: everywhere, nowhere, or at some nodes.
class Projected {
 public:
  Projected(bool everywhere) : all_(everywhere) {}  // NOLINT(google-explicit-constructor): yes and no are answers too
  /// One entry a node, referred to; not 0: marked.
  explicit Projected(std::span<const char> nodes) : nodes_(nodes) {}

  /// Some nodes are marked, and some perhaps are not.
  bool mixed() const { return !nodes_.empty(); }
  /// Whether one of these nodes is marked; negative numbers stand for no node.
  template <class Nodes>
  bool at(const Nodes& nodes) const {
    if (nodes_.empty()) return all_;
    for (const auto node : nodes)
      if (node >= 0 && nodes_[static_cast<std::size_t>(node)] != 0) return true;
    return false;
  }

 private:
  bool all_ = false;
  std::span<const char> nodes_;
};

}  // namespace pf
