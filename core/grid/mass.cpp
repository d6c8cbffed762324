#include "core/grid/mass.hpp"

#include <cmath>

#include "core/grid/stencil.hpp"
#include "core/math/vector_ops.hpp"

namespace pf {

namespace {

std::size_t at(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

/// The batch's masses, a lane a particle; 0 beyond count.
template <int D>
Wide<lane_count<D>> masses(const Particles<D>& particles, const Batch& batch) {
  Wide<lane_count<D>> m{};
  for (int lane = 0; lane < batch.count; ++lane) m[lane] = particles.mass[at(batch.first + lane)];
  return m;
}

}  // namespace

template <int D>
MassMatrix<D>::MassMatrix(const Plan<D>& plan, const Particles<D>& particles, const Vector& lumped,
                          const MassKind& kind, Parallel& parallel, Work& work, MassMemory<D>* memory)
    : plan_(plan),
      particles_(particles),
      lumped_(lumped),
      consistent_(kind.consistent),
      parallel_(parallel),
      work_(work),
      memory_(memory ? *memory : own_) {
  if (!consistent_) return;
  if (particles.size() < static_cast<std::size_t>(plan.node_count())) blend_ = singular_blend;
  memory_.ghost.clear();
  if (kind.ghost_penalty > 0) memory_.ghost.build(plan, lumped, kind.ghost_penalty);
  compute_diagonal();
}

template <int D>
void MassMatrix<D>::compute_diagonal() {
  Vector& diagonal = memory_.diagonal;
  diagonal.setZero(plan_.node_count());
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, 1, decltype(k)::dense>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int) {
      double local[S::nodes] = {};
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[at(i)];
        Wide<lane_count<D>> room[2 * D * K];
        const Wide<lane_count<D>>* const w = plan_.weights(i, room);
        Wide<lane_count<D>> squares[S::values];
        for (int r = 0; r < S::values; ++r) squares[r] = w[r] * w[r];
        const Wide<lane_count<D>> m = masses(particles_, batch);
        S::template scatter<true, false>(&m, nullptr, squares, squares, local + batch.node);
      }
      add_block<D, K, 1>(plan_, block, local, diagonal.data());
    });
  });
  diagonal = (1 - blend_) * diagonal + blend_ * lumped_;
  memory_.ghost.add_diagonal(diagonal);
}

template <int D>
void MassMatrix<D>::multiply(const Vector& v, Vector& out) const {
  out.resize(v.size());
  if (!consistent_) {
    for (Eigen::Index i = 0; i < lumped_.size(); ++i) out.segment<D>(i * D) = lumped_[i] * v.segment<D>(i * D);
    return;
  }
  out.setZero();
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D, decltype(k)::dense>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int) {
      double local[S::nodes * D], result[S::nodes * D] = {};
      load_block<D, K, D>(plan_, block, v.data(), local);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[at(i)];
        Wide<lane_count<D>> room[2 * D * K];
        const Wide<lane_count<D>>* const w = plan_.weights(i, room);
        Wide<lane_count<D>> value[D];
        S::template gather<true, false>(local + batch.node * D, w, w + S::values, value, nullptr);
        const Wide<lane_count<D>> m = masses(particles_, batch);
        for (int a = 0; a < D; ++a) value[a] *= m;
        S::template scatter<true, false>(value, nullptr, w, w + S::values, result + batch.node * D);
      }
      add_block<D, K, D>(plan_, block, result, out.data());
    });
  });
  if (blend_ > 0) {
    out *= 1 - blend_;
    for (Eigen::Index i = 0; i < lumped_.size(); ++i)
      out.segment<D>(i * D) += blend_ * lumped_[i] * v.segment<D>(i * D);
  }
  memory_.ghost.add_product(v, out);
  work_.hessian_product += particles_.size();
}

template <int D>
double MassMatrix<D>::dot(const Vector& a, const Vector& b) const {
  return pf::dot(parallel_, a, b);
}

template <int D>
int MassMatrix<D>::solve(const Vector& b, Vector& v, double& residual) const {
  constexpr double tolerance = 1e-13;
  constexpr int most = 1000;
  auto& [unused, scale, r, Mp, z, p, ghost] = memory_;
  scale.resize(b.size());
  const double smallest = 1e-14 * diagonal().maxCoeff();
  for (Eigen::Index i = 0; i < diagonal().size(); ++i)
    scale.template segment<D>(i * D).setConstant(diagonal()[i] > smallest ? 1 / diagonal()[i] : 0);
  z = scale.cwiseProduct(b);
  const double start = std::max(std::sqrt(dot(b, z)), 1e-300);
  multiply(v, r);
  r = b - r;
  z = scale.cwiseProduct(r);
  p = z;
  double rz = dot(r, z);
  int iteration = 0;
  for (; iteration < most && std::sqrt(rz) > tolerance * start; ++iteration) {
    multiply(p, Mp);
    const double pMp = dot(p, Mp);
    if (!(pMp > 0)) break;
    const double alpha = rz / pMp;
    v += alpha * p;
    r -= alpha * Mp;
    z = scale.cwiseProduct(r);
    const double next = dot(r, z);
    p = z + (next / rz) * p;
    rz = next;
  }
  residual = std::sqrt(rz) / start;
  return iteration;
}

template <int D>
void MassMatrix<D>::assemble(double factor, BlockMatrix<D>& H) const {
  const double lumped_part = consistent_ ? blend_ : 1;
  if (lumped_part > 0)
    for (int i = 0; i < H.rows(); ++i) H.at(i, i).diagonal().array() += factor * lumped_part * lumped_[i];
  if (!consistent_) return;
  memory_.ghost.assemble(factor, H);
  factor *= 1 - blend_;
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k, count = D == 2 ? K * K : K * K * K;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int) {
      const std::int32_t* table = plan_.node_table(block);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[at(i)];
        const Wide<lane_count<D>> m = masses(particles_, batch);
        std::int32_t node[count];
        Wide<lane_count<D>> N[count], room[2 * D * K];
        const Wide<lane_count<D>>* const w = plan_.weights(i, room);
        for (int n = 0; n < count; ++n) {
          node[n] = table[batch.node + node_offset<D, K>(n)];
          N[n] = node_value<D, K, decltype(k)::dense>(w, n);
        }
        for (int r = 0; r < count; ++r)
          for (int c = 0; c < count; ++c)
            if (node[c] >= 0 && node[r] >= node[c])
              H.at(node[r], node[c]).diagonal().array() += factor * sum_lanes(Wide<lane_count<D>>(m * N[r] * N[c]));
      }
    });
  });
}

template class MassMatrix<2>;
template class MassMatrix<3>;

}  // namespace pf
