#include "core/step/rigid_motion.hpp"

#include <Eigen/Eigenvalues>
#include <cstdio>
#include <map>
#include <numeric>

namespace pf {

namespace {

constexpr int modes(int dimension) {
  return dimension == 2 ? 3 : 6;
}
template <int D>
using Modes = Eigen::Matrix<double, modes(D), 1>;

template <int D>
using Square = Eigen::Matrix<double, modes(D), modes(D)>;

/// Nodes that share particles, directly or through others.
template <int D>
struct Part {
  Vec<D> centre = Vec<D>::Zero();
  double nodes = 0, size = 0;
  Square<D> held = Square<D>::Zero();  ///< sum of row row^T over what is held
};

/// How a rigid motion moves a point at r along axis d: d for the translations, d . (e_k x r) for the rotations.
template <int D>
Modes<D> row_of(const Vec<D>& d, const Vec<D>& r) {
  Modes<D> row;
  row.template head<D>() = d;
  if constexpr (D == 2)
    row[2] = d[1] * r[0] - d[0] * r[1];
  else
    row.template tail<3>() = r.cross(d);
  return row;
}

/// The part of the grid that each node is connected with: its first node.
template <int D>
std::vector<std::int32_t> parts_of(const Plan<D>& plan) {
  std::vector<std::int32_t> parent(static_cast<std::size_t>(plan.node_count()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::int32_t i) {
    while (parent[static_cast<std::size_t>(i)] != i) {
      auto& up = parent[static_cast<std::size_t>(i)];
      i = up = parent[static_cast<std::size_t>(up)];
    }
    return i;
  };
  const int K = plan.nodes_per_axis(), edge = block_edge + K - 1;
  for (const Block<D>& block : plan.blocks()) {
    const std::int32_t* table = plan.node_table(block);
    for (int b = block.batch_begin; b < block.batch_end; ++b) {
      const int first = plan.batches()[static_cast<std::size_t>(b)].node;
      std::int32_t a = -1;
      for (int n = 0; n < (D == 2 ? K * K : K * K * K); ++n) {
        const std::int32_t node = table[first + n % K + edge * (n / K % K + edge * (n / (K * K)))];
        if (node < 0) continue;
        if (a < 0) a = root(node);
        const std::int32_t other = root(node);
        parent[static_cast<std::size_t>(std::max(root(a), other))] = std::min(root(a), other);
      }
    }
  }
  for (std::int32_t i = 0; i < plan.node_count(); ++i) parent[static_cast<std::size_t>(i)] = root(i);
  return parent;
}

}  // namespace

template <int D>
std::string free_rigid_motion(const Plan<D>& plan, const FeasibleSet<D>& set) {
  constexpr int N = modes(D);
  const std::vector<std::int32_t> part_of = parts_of(plan);
  std::map<std::int32_t, Part<D>> parts;
  const auto part = [&](std::int32_t i) -> Part<D>& { return parts[part_of[static_cast<std::size_t>(i)]]; };
  for (std::int32_t i = 0; i < plan.node_count(); ++i) {
    part(i).centre += plan.node_position(i);
    part(i).nodes += 1;
  }
  for (auto& [first, p] : parts) p.centre /= p.nodes;
  for (std::int32_t i = 0; i < plan.node_count(); ++i)
    part(i).size = std::max(part(i).size, (plan.node_position(i) - part(i).centre).norm());
  for (const NodeConstraint<D>& c : set.constrained) {
    Part<D>& p = part(c.node);
    const Vec<D> r = (plan.node_position(c.node) - p.centre) / std::max(p.size, 1e-300);
    const auto hold = [&](const Vec<D>& d) {
      const Modes<D> row = row_of<D>(d, r);
      p.held += row * row.transpose();
    };
    const bool rubs = c.friction > 0;
    for (int a = 0; a < D; ++a) hold(rubs ? Vec<D>::Unit(a) : Vec<D>(Vec<D>::Unit(a) - c.free.col(a)));
    for (int k = 0; k < c.faces; ++k) hold(c.normal[static_cast<std::size_t>(k)]);
  }
  for (const auto& [first, p] : parts) {
    const Eigen::SelfAdjointEigenSolver<Square<D>> solver(p.held);
    if (solver.eigenvalues()[0] > 1e-9 * std::max(1.0, solver.eigenvalues()[N - 1])) continue;
    const Mat<D> shifts = p.held.template topLeftCorner<D, D>();
    const Eigen::SelfAdjointEigenSolver<Mat<D>> shifting(shifts);
    const bool turns = shifting.eigenvalues()[0] > 1e-9 * std::max(1.0, shifting.eigenvalues()[D - 1]);
    char text[200];
    std::snprintf(text, sizeof text,
                  "what lies about (%.3g, %.3g%s) is free to %s: without inertia nothing decides where", p.centre[0],
                  p.centre[1], D == 3 ? ", ..." : "", turns ? "turn" : "move");
    return text;
  }
  return "";
}

template std::string free_rigid_motion<2>(const Plan<2>&, const FeasibleSet<2>&);
template std::string free_rigid_motion<3>(const Plan<3>&, const FeasibleSet<3>&);

}  // namespace pf
