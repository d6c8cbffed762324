// Second derivatives of the elastic energy where particles share their changes of volume (F-bar,
// core/energies/volume_patches.hpp). With G = F^^-T, f = F^ as vectors, L = ln J~, l_p = ln J^_p and
// s_p = exp((L - l_p)/D), F-bar = s F^ F_n changes by
//
//     dF-bar = s (dF^ + f (dL - G . dF^)/D) F_n,   dL = sum_p w_p G_p . dF^_p,
//
// w_p the share of the patch's volume. What is of one particle goes into its tangent, what is of L couples the patch.
#include <Eigen/LU>

#include "core/energies/elastic_kernels.hpp"
#include "core/energies/elastic_patches.hpp"

namespace pf {

namespace {

template <int D>
using Row = Eigen::Matrix<double, D * D, 1>;

template <int D>
Row<D> as_row(const Mat<D>& A) {
  return Eigen::Map<const Row<D>>(A.data());
}

/// (F_n (x) I) A (F_n (x) I)^T: a tangent with respect to F becomes one with respect to F^.
template <int D>
Tangent<D> pushed(const Mat<D>& F_n, const Tangent<D>& A) {
  Tangent<D> half = Tangent<D>::Zero(), whole = Tangent<D>::Zero();
  for (int b = 0; b < D; ++b)
    for (int B = 0; B < D; ++B) half.template middleRows<D>(D * b) += F_n(b, B) * A.template middleRows<D>(D * B);
  for (int b = 0; b < D; ++b)
    for (int B = 0; B < D; ++B) whole.template middleCols<D>(D * b) += F_n(b, B) * half.template middleCols<D>(D * B);
  return whole;
}

/// The form tr(F^^-1 X F^^-1 X) = -d2 ln J^ (X, X).
template <int D>
Tangent<D> second_of_log(const Mat<D>& inverse) {
  Tangent<D> S;
  for (int d = 0; d < D; ++d)
    for (int c = 0; c < D; ++c)
      for (int b = 0; b < D; ++b)
        for (int a = 0; a < D; ++a) S(a + D * b, c + D * d) = inverse(d, a) * inverse(b, c);
  return S;
}

/// Second derivatives of psi(F-bar) with respect to F^ and L.
template <int D>
struct BarredTangent {
  Tangent<D> FF;
  Row<D> FL;
  double LL, L;  ///< L: the first derivative with respect to L
};

/// `A`: dP/dF at F-bar with respect to F^, times s^2; `P`: s P F_n^T. Without P's own part where `project`: a sum of
/// squares if A is one.
template <int D>
BarredTangent<D> barred_tangent(const Tangent<D>& A, const Row<D>& P, const Mat<D>& hat, const Mat<D>& inverse,
                                bool project) {
  const Row<D> f = as_row<D>(hat), G = as_row<D>(inverse.transpose()), h = A * f;
  const double k = f.dot(h), tau = P.dot(f);
  BarredTangent<D> t{A, h / D - k / (D * D) * G, k / (D * D), 0};
  t.FF -= (G * h.transpose() + h * G.transpose()) / D;
  t.FF += k / (D * D) * G * G.transpose();
  if (project) return t;
  t.FF -= (P * G.transpose() + G * P.transpose()) / D;
  t.FF += tau / (D * D) * G * G.transpose() + tau / D * second_of_log<D>(inverse);
  t.FL += P / D - tau / (D * D) * G;
  t.LL += tau / (D * D);
  t.L = tau / D;
  return t;
}

/// Where each particle of a block has its packed tangent.
template <int D>
std::vector<float*> places(const Plan<D>& plan, const Block<D>& block, Narrow<lane_count<D>>* tangents) {
  constexpr int components = tangent_components<D>, W = lane_count<D>;
  std::vector<float*> place(index(block.particle_end - block.particle_begin));
  for (int i = block.batch_begin; i < block.batch_end; ++i) {
    const Batch& batch = plan.batches()[index(i)];
    Narrow<W>* const to = tangents + index(i) * components;
    if (batch.count < W) std::fill(to, to + components, Narrow<W>{});
    for (int lane = 0; lane < batch.count; ++lane)
      place[index(batch.first + lane - block.particle_begin)] = reinterpret_cast<float*>(to) + lane;
  }
  return place;
}

/// sum_p of_p grad N_i of a patch's particles, on the nodes of its cell: D components a node.
template <int D, int K, bool Dense>
void to_nodes(const Plan<D>& plan, const VolumePatch& patch, const Mat<D>* of, double* nodes) {
  constexpr int W = lane_count<D>, count = PatchCoupling<D, K>::nodes;
  std::fill(nodes, nodes + count * D, 0.0);
  for (int i = patch.batch_begin; i < patch.batch_end; ++i) {
    const Batch& batch = plan.batches()[index(i)];
    Wide<W> room[2 * D * K], lanes[D * D] = {}, grad[D];
    const Wide<W>* const w = plan.weights(i, room);
    for (int lane = 0; lane < batch.count; ++lane) {
      const std::int32_t p = batch.first + lane;
      if (p < patch.begin || p >= patch.end) continue;  // another material's
      for (int c = 0; c < D * D; ++c) lanes[c][lane] = of[p - patch.begin](c);
    }
    for (int n = 0; n < count; ++n) {
      node_gradient<D, K, Dense>(w, n, grad);
      for (int c = 0; c < D; ++c) {
        Wide<W> sum{};
        for (int b = 0; b < D; ++b) sum += lanes[c + D * b] * grad[b];
        nodes[n * D + c] += sum_lanes(sum);
      }
    }
  }
}

}  // namespace

/// Of particles in no patch.
template <int D>
void ElasticEnergy<D>::single_tangents(const Block<D>& block, bool project, const BarredBlock<D>& state,
                                       const std::vector<float*>& place) const {
  const auto begin = index(block.particle_begin);
  for_each_material(
      plan_, block, block.particle_begin, block.particle_end, [&](std::uint16_t material, int first, std::size_t n) {
        const std::size_t from = index(first) - begin;
        for (std::size_t k = from, last; k < from + n; k = last) {
          last = k + 1;
          if (state.share[k] > 0) continue;
          while (last < from + n && state.share[last] == 0) ++last;
          const std::size_t count = last - k;
          laws_[material]->grid_tangent({state.F.data() + k, count}, {particles_.F.data() + begin + k, count},
                                        {particles_.volume0.data() + begin + k, count}, project,
                                        {place.data() + k, count}, W);
        }
      });
}

/// Of a patch's particles; `of_L` and `of_volume` become what couples them: d2E/dF^dL and dL/dF^. Returns d2E/dLdL.
template <int D>
double ElasticEnergy<D>::patch_tangents(const Block<D>& block, const VolumePatch& patch, bool project,
                                        const BarredBlock<D>& state, const std::vector<float*>& place,
                                        std::vector<Mat<D>>& of_L, std::vector<Mat<D>>& of_volume) const {
  const auto begin = index(patch.begin), n = index(patch.end - patch.begin),
             first = begin - index(block.particle_begin);
  std::vector<Tangent<D>> A(n);
  of_L.resize(n), of_volume.resize(n);
  laws_[particles_.material[begin]]->tangent({state.F.data() + first, n}, project, A);
  double LL = 0, L = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Mat<D>&F_n = particles_.F[begin + k], &hat = state.hat[first + k], inverse = hat.inverse();
    const double V = particles_.volume0[begin + k], s = state.stretch[first + k];
    const Mat<D> P = s * state.P[first + k] * F_n.transpose();
    const BarredTangent<D> t = barred_tangent<D>(s * s * pushed<D>(F_n, A[k]), as_row<D>(P), hat, inverse, project);
    A[k] = V * t.FF;
    Eigen::Map<Row<D>>(of_L[k].data()) = V * t.FL;
    of_volume[k] = state.share[first + k] * inverse.transpose();
    LL += V * t.LL;
    L += V * t.L;
  }
  for (std::size_t k = 0; k < n; ++k) {
    // d2L = sum_p w_p ((G . X)^2 - tr(F^^-1 X F^^-1 X)) - dL^2
    const Mat<D> inverse = state.hat[first + k].inverse();
    const Row<D> G = as_row<D>(inverse.transpose());
    if (!project) A[k] += L * state.share[first + k] * (G * G.transpose() - second_of_log<D>(inverse));
    if (project) A[k].diagonal().array() += 0x1p-24 * A[k].trace();  // against rounding, as Law::grid_tangent does
    for (int row = 0; row < D * D; ++row)
      for (int column = row; column < D * D; ++column)
        place[first + k][packed_tangent_index<D>(row, column) * W] = static_cast<float>(A[k](row, column));
  }
  return LL - L;
}

template <int D>
void ElasticEnergy<D>::block_tangents(const Block<D>& block, int b, bool project, BarredBlock<D>& state) {
  const std::vector<float*> place = places(plan_, block, tangent_);
  block_stress(block, state);
  single_tangents(block, project, state, place);
  std::vector<Mat<D>> of_L, of_volume;
  auto number = index(memory_.patch_start[index(b)]);
  for_each_patch(plan_, particles_, laws_, block, [&](const VolumePatch& patch) {
    const double k = patch_tangents(block, patch, project, state, place, of_L, of_volume);
    with_nodes_per_axis(plan_, [&](auto nodes) {
      constexpr int K = nodes;
      using Coupling = PatchCoupling<D, K>;
      double* const to = memory_.patch_coupling.data() + number * Coupling::size;
      to_nodes<D, K, decltype(nodes)::dense>(plan_, patch, of_L.data(), to);
      to_nodes<D, K, decltype(nodes)::dense>(plan_, patch, of_volume.data(), to + Coupling::values);
      to[Coupling::size - 1] = k;
    });
    memory_.patch_node[number++] = patch.node;
  });
}

template <int D>
void ElasticEnergy<D>::barred_tangents(const Vector& u, const Projected& project) {
  const std::vector<Block<D>>& blocks = plan_.blocks();
  memory_.patch_start.assign(blocks.size() + 1, 0);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    std::int32_t count = 0;
    for_each_patch(plan_, particles_, laws_, blocks[b], [&](const VolumePatch&) { ++count; });
    memory_.patch_start[b + 1] = memory_.patch_start[b] + count;
  }
  const auto patches = index(memory_.patch_start.back());
  memory_.patch_node.resize(patches);
  with_nodes_per_axis(plan_, [&](auto k) { memory_.patch_coupling.resize(patches * PatchCoupling<D, k>::size); });
  for_each_block(plan_, parallel_, [&](const Block<D>& block, int b) {
    BarredBlock<D> state;
    deform_block(block, &u, state);
    // Blocks are projected as a whole: some cells more than asked for.
    bool here = false;
    for (int i = block.batch_begin; i < block.batch_end && !here; ++i)
      here = meets(plan_, block, plan_.batches()[index(i)], project);
    block_tangents(block, b, here, state);
  });
}

// NOLINTBEGIN(bugprone-macro-parentheses): D is a template argument.
#define PF_INSTANTIATE(D)                                                                                            \
  template void ElasticEnergy<D>::barred_tangents(const Vector&, const Projected&);                                  \
  template void ElasticEnergy<D>::block_tangents(const Block<D>&, int, bool, BarredBlock<D>&);                       \
  template void ElasticEnergy<D>::single_tangents(const Block<D>&, bool, const BarredBlock<D>&,                      \
                                                  const std::vector<float*>&) const;                                 \
  template double ElasticEnergy<D>::patch_tangents(const Block<D>&, const VolumePatch&, bool, const BarredBlock<D>&, \
                                                   const std::vector<float*>&, std::vector<Mat<D>>&,                 \
                                                   std::vector<Mat<D>>&) const;
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace pf
