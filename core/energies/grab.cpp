#include "core/energies/grab.hpp"

#include <map>
#include <unordered_map>

#include "core/grid/stencil.hpp"

namespace pf {

template <int D>
GrabSpring<D>::GrabSpring(const Plan<D>& plan, const Particles<D>& particles, const Held& held, const Vec<D>& target,
                          double stiffness)
    : target_(target), stiffness_(stiffness) {
  std::unordered_map<std::uint32_t, double> weight;
  for (std::size_t i = 0; i < held.id.size(); ++i) weight.emplace(held.id[i], held.weight[i]);
  std::map<std::int32_t, double> nodes;
  for (const Block<D>& block : plan.blocks())
    for (int i = block.batch_begin; i < block.batch_end; ++i) {
      const Batch& batch = plan.batches()[static_cast<std::size_t>(i)];
      for (int lane = 0; lane < batch.count; ++lane) {
        const auto p = static_cast<std::size_t>(batch.first) + static_cast<std::size_t>(lane);
        const auto found = weight.find(particles.id[p]);
        if (found == weight.end()) continue;
        start_ += found->second * particles.x[p];
        Wide<lane_count<D>> room[2 * D * max_nodes_per_axis];
        const Wide<lane_count<D>>* const w = plan.weights(i, room);
        with_nodes_per_axis(plan, [&](auto k) {
          constexpr int K = k;
          for (int n = 0; n < (D == 2 ? K * K : K * K * K); ++n) {
            const std::int32_t node = plan.node_table(block)[batch.node + node_offset<D, K>(n)];
            if (node >= 0) nodes[node] += found->second * node_value<D, K, decltype(k)::dense>(w, n)[lane];
          }
        });
      }
    }
  nodes_.assign(nodes.begin(), nodes.end());
}

template <int D>
Vec<D> GrabSpring<D>::held_position(const Vector& u) const {
  Vec<D> x = start_;
  for (const auto& [node, a] : nodes_) x += a * u.segment<D>(node * D);
  return x;
}

template <int D>
double GrabSpring<D>::value(const Vector& u) {
  return 0.5 * stiffness_ * (held_position(u) - target_).squaredNorm();
}

template <int D>
double GrabSpring<D>::gradient(const Vector& u, Vector& g, Vector& magnitude) {
  const Vec<D> f = force(u);
  for (const auto& [node, a] : nodes_) {
    g.segment<D>(node * D) -= a * f;
    magnitude[node] += a * f.norm();
  }
  return 0.5 * f.squaredNorm() / stiffness_;
}

template <int D>
void GrabSpring<D>::hessian_product(const Vector& p, Vector& Hp) {
  Vec<D> moved = Vec<D>::Zero();
  for (const auto& [node, a] : nodes_) moved += a * p.segment<D>(node * D);
  for (const auto& [node, a] : nodes_) Hp.segment<D>(node * D) += stiffness_ * a * moved;
}

template <int D>
void GrabSpring<D>::diagonal(std::vector<Mat<D>>& blocks) {
  for (const auto& [node, a] : nodes_) blocks[static_cast<std::size_t>(node)].diagonal().array() += stiffness_ * a * a;
}

template <int D>
void GrabSpring<D>::assemble(BlockMatrix<D>& H) {
  for (const auto& [node, a] : nodes_) H.at(node, node).diagonal().array() += stiffness_ * a * a;
}

template class GrabSpring<2>;
template class GrabSpring<3>;

}  // namespace pf
