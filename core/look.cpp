#include "core/look.hpp"

#include "core/params/problem.hpp"

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

std::vector<NodeWeight> recorded_weights(const StepRecord& record, std::size_t particle) {
  const auto d = static_cast<std::size_t>(record.dimension), K = static_cast<std::size_t>(record.nodes_per_axis);
  const std::size_t count = d == 3 ? K * K * K : K * K;
  if (K == 0 || record.weights.size() < (particle + 1) * count * (1 + d)) return {};
  std::vector<NodeWeight> nodes(count);
  const float* value = record.weights.data() + particle * count * (1 + d);
  for (std::size_t n = 0; n < count; ++n, value += 1 + d) {
    NodeWeight& node = nodes[n];
    std::size_t rest = n;
    for (std::size_t a = 0; a < d; ++a, rest /= K) {
      node.node[a] = record.first_node[particle * d + a] + static_cast<std::int32_t>(rest % K);
      node.grad[static_cast<Eigen::Index>(a)] = static_cast<double>(value[1 + a]);
    }
    node.w = static_cast<double>(value[0]);
  }
  return nodes;
}

std::size_t Simulation::stroke(const Stroke& stroke) {
  throw InputError(
      "", {{"/events/-/strokes/-", "\"" + stroke.kind + "\"", "a simulation whose particles can be worked on", 0}});
}

Look Simulation::look(const LookQuestion& question) const {
  Look look;
  look.step = report().step;
  look.time = time();
  if (question.particle && has_particle(*question.particle))
    look.particle.emplace().state = particle(*question.particle);
  return look;
}

}  // namespace pf
