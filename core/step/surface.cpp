#include "core/step/surface.hpp"

namespace pf {

namespace {

/// Calls f(node, weight) for the active nodes around x, weights adding up to 1; nothing when there are none.
template <int D, class Function>
void around(const Plan<D>& plan, const Vec<D>& x, Function&& f) {
  const int K = plan.nodes_per_axis();
  double N[D][max_nodes_per_axis], dN[max_nodes_per_axis];
  long long base[D];
  for (int a = 0; a < D; ++a) {
    plan.basis().weights(x[a] / plan.spacing(), base[a], N[a], dN);
    end_at_walls(K, plan.edges(a), base[a], 1, N[a]);
  }
  const int count = D == 2 ? K * K : K * K * K;
  int nodes[max_nodes_per_axis * max_nodes_per_axis * max_nodes_per_axis];
  double weights[max_nodes_per_axis * max_nodes_per_axis * max_nodes_per_axis];
  double sum = 0;
  for (int n = 0; n < count; ++n) {
    const int r[3] = {n % K, n / K % K, n / (K * K)};
    std::array<long long, D> index;
    weights[n] = 1;
    for (int a = 0; a < D; ++a) {
      index[static_cast<std::size_t>(a)] = base[a] + r[a];
      weights[n] *= N[a][r[a]];
    }
    nodes[n] = plan.find_node(index);
    if (nodes[n] >= 0) sum += weights[n];
  }
  if (!(sum > 0)) return;
  for (int n = 0; n < count; ++n)
    if (nodes[n] >= 0) f(nodes[n], weights[n] / sum);
}

}  // namespace

template <int D>
void SurfacePoints<D>::spread(const Plan<D>& plan, const std::vector<Vec<D>>& traction, Vector& f) const {
  for (std::size_t s = 0; s < size(); ++s) {
    const Vec<D> force = area[s] * traction[s];
    around<D>(plan, x[s], [&](int node, double weight) { f.segment<D>(node * D) += weight * force; });
  }
}

template <int D>
void SurfacePoints<D>::move(const Plan<D>& plan, const Vector& u) {
  for (Vec<D>& at : x) {
    Vec<D> moved = Vec<D>::Zero();
    around<D>(plan, at, [&](int node, double weight) { moved += weight * u.segment<D>(node * D); });
    at += moved;
  }
}

template struct SurfacePoints<2>;
template struct SurfacePoints<3>;

}  // namespace pf
