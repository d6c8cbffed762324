#include "core/look.hpp"

namespace pf {

std::vector<NodeWeight> weights_at(const BasisInfo& basis, double spacing, int dimension, const Vec3& x) {
  const int K = basis.nodes_per_axis;
  std::array<long long, 3> base{};
  double N[3][max_nodes_per_axis] = {}, dN[3][max_nodes_per_axis] = {};
  for (int a = 0; a < dimension; ++a) basis.weights(x[a] / spacing, base[static_cast<std::size_t>(a)], N[a], dN[a]);
  std::vector<NodeWeight> nodes;
  for (int k = 0; k < (dimension == 3 ? K : 1); ++k)
    for (int j = 0; j < K; ++j)
      for (int i = 0; i < K; ++i) {
        const std::array<int, 3> r{i, j, k};
        NodeWeight n;
        std::array<double, 3> grad{1 / spacing, 1 / spacing, dimension == 3 ? 1 / spacing : 0};
        n.w = 1;
        for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
          n.node[a] = static_cast<std::int32_t>(base[a] + r[a]);
          n.w *= N[a][r[a]];
          for (std::size_t b = 0; b < 3; ++b) grad[b] *= a == b ? dN[a][r[a]] : N[a][r[a]];
        }
        n.grad = Vec3(grad[0], grad[1], grad[2]);
        nodes.push_back(n);
      }
  return nodes;
}

Look Simulation::look(const LookQuestion& question) const {
  Look look;
  look.step = report().step;
  look.time = time();
  if (question.particle) look.particle.emplace().state = particle(*question.particle);
  return look;
}

}  // namespace pf
