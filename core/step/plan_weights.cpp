#include "core/step/plan_weights.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace pf {

namespace {

/// Value and gradient of node n of the stencil, for one particle: of weights of each node by itself, of products.
template <int D>
void read_dense(const Wide<lane_count<D>>* w, int nodes, int n, int lane, NodeWeight& into) {
  into.w = w[n][lane];
  for (int a = 0; a < D; ++a) into.grad[a] = w[(1 + a) * nodes + n][lane];
}

template <int D>
void read_product(const Wide<lane_count<D>>* w, int K, const std::array<int, D>& r, int lane, NodeWeight& into) {
  into.w = 1;
  into.grad.template head<D>().setOnes();
  for (int a = 0; a < D; ++a) {
    const int k = a * K + r[static_cast<std::size_t>(a)];
    into.w *= w[k][lane];
    for (int b = 0; b < D; ++b) into.grad[b] *= a == b ? w[D * K + k][lane] : w[k][lane];
  }
}

}  // namespace

template <int D>
std::vector<NodeWeight> weights_in(const Plan<D>& plan, std::size_t particle) {
  const auto p = static_cast<std::int32_t>(particle);
  const auto block =
      std::prev(std::upper_bound(plan.blocks().begin(), plan.blocks().end(), p,
                                 [](std::int32_t q, const Block<D>& b) { return q < b.particle_begin; }));
  const auto first = plan.batches().begin();
  const auto batch = std::prev(std::upper_bound(first + block->batch_begin, first + block->batch_end, p,
                                                [](std::int32_t q, const Batch& b) { return q < b.first; }));
  std::array<Wide<lane_count<D>>, 2 * D * max_nodes_per_axis> room;
  const Wide<lane_count<D>>* const w = plan.weights(static_cast<int>(batch - first), room.data());
  const int K = plan.nodes_per_axis(), edge = block_edge + K - 1, lane = p - batch->first;
  const int count = D == 2 ? K * K : K * K * K;
  std::array<long long, D> base = block->corner;
  for (int a = 0, node = batch->node; a < D; ++a, node /= edge) base[static_cast<std::size_t>(a)] += node % edge;

  std::vector<NodeWeight> nodes(static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n) {
    NodeWeight& into = nodes[static_cast<std::size_t>(n)];
    std::array<int, D> r{};
    for (std::size_t a = 0, rest = static_cast<std::size_t>(n); a < D; ++a, rest /= static_cast<std::size_t>(K)) {
      r[a] = static_cast<int>(rest % static_cast<std::size_t>(K));
      into.node[a] = static_cast<std::int32_t>(base[a] + r[a]);
    }
    if (plan.dense())
      read_dense<D>(w, count, n, lane, into);
    else
      read_product<D>(w, K, r, lane, into);
  }
  return nodes;
}

template std::vector<NodeWeight> weights_in<2>(const Plan<2>&, std::size_t);
template std::vector<NodeWeight> weights_in<3>(const Plan<3>&, std::size_t);

}  // namespace pf
