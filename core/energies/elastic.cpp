#include "core/energies/elastic.hpp"

#include <algorithm>
#include <cmath>

#include "core/energies/elastic_kernels.hpp"
#include "core/energies/elastic_patches.hpp"
#include "core/grid/records.hpp"

namespace pf {

template <int D>
void ElasticEnergy<D>::deform(const double* local, Chunk& chunk) const {
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D, decltype(k)::dense>;
    for (int i = chunk.batch_begin; i < chunk.batch_end; ++i) {
      const Batch& batch = plan_.batches()[index(i)];
      Wide<W> room[2 * D * K];
      const Wide<W>* const w = plan_.weights(i, room);
      Wide<W> gradient[D][D];
      S::template gather<false, true>(local + batch.node * D, w, w + S::values, nullptr, gradient);
      Wide<W> F_hat[D * D], F_n[D * D], F[D * D];
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) F_hat[a + D * b] = a == b ? gradient[a][b] + 1.0 : gradient[a][b];
      load_lanes<D * D>(particles_.F[index(batch.first)].data(), batch.count, F_n);
      multiply_lanes<D>(F_hat, F_n, F);
      store_lanes<D * D>(F, batch.count, chunk.F[batch.first - chunk.begin].data());
    }
  });
}

template <int D>
template <class Body>
void ElasticEnergy<D>::for_each_deformed(const Block<D>& block, const Vector& u, Body&& body) const {
  double local[most_block_nodes * D];
  with_nodes_per_axis(plan_, [&](auto k) { load_block<D, k, D>(plan_, block, u.data(), local); });
  for_each_chunk(plan_, block, [&](Chunk& chunk) {
    deform(local, chunk);
    body(chunk);
  });
}

template <int D>
std::vector<Mat<D>> ElasticEnergy<D>::deformed(const Vector& u) const {
  std::vector<Mat<D>> F(particles_.size());
  if (barred()) {
    BarredBlock<D> state;
    for (const Block<D>& block : plan_.blocks()) {
      deform_block(block, &u, state);
      std::copy(state.F.begin(), state.F.end(), F.begin() + block.particle_begin);
    }
    return F;
  }
  for (const Block<D>& block : plan_.blocks())
    for_each_deformed(
        block, u, [&](const Chunk& chunk) { std::copy_n(chunk.F, chunk.end - chunk.begin, F.begin() + chunk.begin); });
  return F;
}

template <int D>
double ElasticEnergy<D>::chunk_energy(const Chunk& chunk) const {
  double sum = 0;
  for (int p = chunk.begin; p < chunk.end; ++p) sum += particles_.volume0[index(p)] * chunk.psi[p - chunk.begin];
  return sum;
}

template <int D>
double ElasticEnergy<D>::ordered_sum() const {
  double sum = 0;
  for (const double s : memory_.block_sum) sum += s;
  return sum;
}

template <int D>
double ElasticEnergy<D>::value(const Vector& u) {
  if (barred()) return barred_value(u);
  memory_.block_sum.resize(plan_.blocks().size());
  for_each_block(plan_, parallel_, [&](const Block<D>& block, int b) {
    double sum = 0;
    for_each_deformed(block, u, [&](Chunk& chunk) {
      for_each_material(plan_, block, chunk.begin, chunk.end, [&](std::uint16_t material, int first, std::size_t n) {
        laws_[material]->energy({chunk.F + (first - chunk.begin), n}, {chunk.psi + (first - chunk.begin), n});
      });
      sum += chunk_energy(chunk);
    });
    memory_.block_sum[index(b)] = sum;
  });
  work_.energy += particles_.size();
  return ordered_sum();
}

template <int D>
void ElasticEnergy<D>::chunk_stress(const Block<D>& block, const Mat<D>* F, Chunk& chunk) const {
  for_each_material(plan_, block, chunk.begin, chunk.end, [&](std::uint16_t material, int first, std::size_t n) {
    const int at = first - chunk.begin;
    laws_[material]->stress({F + at, n}, {chunk.psi + at, n}, {chunk.P + at, n});
  });
}

template <int D>
void ElasticEnergy<D>::batch_flux(const Batch& batch, const Mat<D>* stress, Wide<W> (*flux)[D]) const {
  Wide<W> P[D * D], F_n[D * D];
  load_lanes<D * D>(stress->data(), batch.count, P);
  load_lanes<D * D>(particles_.F[index(batch.first)].data(), batch.count, F_n);
  const auto V = load_lane<Wide<W>>(particles_.volume0.data() + batch.first, batch.count);
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c) {
      Wide<W> sum = P[a] * F_n[c];
      for (int k = 1; k < D; ++k) sum += P[a + D * k] * F_n[c + D * k];
      flux[a][c] = V * sum;
    }
}

template <int D>
double ElasticEnergy<D>::sum_force_at_rest(Vector& g) {
  if (barred()) return barred_gradient(nullptr, g, nullptr);
  memory_.block_sum.resize(plan_.blocks().size());
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D, decltype(k)::dense>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int b) {
      double local[S::nodes * D] = {};
      double energy = 0;
      for_each_chunk(plan_, block, [&](Chunk& chunk) {
        chunk_stress(block, particles_.F.data() + chunk.begin, chunk);
        energy += chunk_energy(chunk);
        for (int i = chunk.batch_begin; i < chunk.batch_end; ++i) {
          const Batch& batch = plan_.batches()[index(i)];
          Wide<W> room[2 * D * K];
          const Wide<W>* const w = plan_.weights(i, room);
          Wide<W> flux[D][D];
          batch_flux(batch, chunk.P + (batch.first - chunk.begin), flux);
          S::template scatter<false, true>(nullptr, flux, w, w + S::values, local + batch.node * D);
        }
      });
      memory_.block_sum[index(b)] = energy;
      add_block<D, K, D>(plan_, block, local, g.data());
    });
  });
  return ordered_sum();
}

template <int D>
double ElasticEnergy<D>::find_rest() {
  memory_.rest_force.setZero(static_cast<Eigen::Index>(plan_.node_count()) * D);
  memory_.rest_energy = sum_force_at_rest(memory_.rest_force);
  memory_.rest_plan = plan_.made();
  return memory_.rest_energy;
}

template <int D>
void ElasticEnergy<D>::add_force_at_rest(Vector& g) {
  if (memory_.rest_plan == plan_.made())
    g += memory_.rest_force;
  else
    sum_force_at_rest(g);
  work_.gradient += particles_.size();
}

template <int D>
double ElasticEnergy<D>::gradient(const Vector& u, Vector& g, Vector& magnitude) {
  if (barred()) {
    work_.gradient += particles_.size();
    return barred_gradient(&u, g, &magnitude);
  }
  memory_.block_sum.resize(plan_.blocks().size());
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D, decltype(k)::dense>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int b) {
      double local[S::nodes * D] = {};
      double local_size[S::nodes] = {};
      double energy = 0;
      for_each_deformed(block, u, [&](Chunk& chunk) {
        chunk_stress(block, chunk.F, chunk);
        energy += chunk_energy(chunk);
        for (int i = chunk.batch_begin; i < chunk.batch_end; ++i) {
          const Batch& batch = plan_.batches()[index(i)];
          Wide<W> room[2 * D * K];
          const Wide<W>* const w = plan_.weights(i, room);
          Wide<W> flux[D][D];
          batch_flux(batch, chunk.P + (batch.first - chunk.begin), flux);
          S::template scatter<false, true>(nullptr, flux, w, w + S::values, local + batch.node * D);
          scatter_sizes<D, K, decltype(k)::dense>(flux, w, local_size + batch.node);
        }
      });
      memory_.block_sum[index(b)] = energy;
      add_block<D, K, D>(plan_, block, local, g.data());
      add_block<D, K, 1>(plan_, block, local_size, magnitude.data());
    });
  });
  work_.gradient += particles_.size();
  return ordered_sum();
}

template <int D>
double ElasticEnergy<D>::rounding(Vector& level) {
  constexpr double units = 8 * std::numeric_limits<double>::epsilon();
  memory_.block_sum.resize(plan_.blocks().size());
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, 1, decltype(k)::dense>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int b) {
      double local[S::nodes] = {};
      double stiffness = 0;
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[index(i)];
        Wide<W> room[2 * D * K], flux[D][D] = {};
        for (int lane = 0; lane < batch.count; ++lane) {
          const std::size_t p = index(batch.first + lane);
          const double c = laws_[particles_.material[p]]->wave_speed(particles_.mass[p] / particles_.volume0[p]);
          for (int a = 0; a < D; ++a) flux[a][a][lane] = units * particles_.mass[p] * c * c;
          stiffness += particles_.mass[p] * c * c;
        }
        scatter_sizes<D, K, decltype(k)::dense>(flux, plan_.weights(i, room), local + batch.node);
      }
      memory_.block_sum[index(b)] = stiffness;
      add_block<D, K, 1>(plan_, block, local, level.data());
    });
  });
  return ordered_sum();
}

template <int D>
void ElasticEnergy<D>::chunk_tangents(const Block<D>& block, const Chunk& chunk, const Projected& project) {
  float* place[Chunk::most];
  for (int i = chunk.batch_begin; i < chunk.batch_end; ++i) {
    const Batch& batch = plan_.batches()[index(i)];
    Narrow<W>* const to = tangent_ + index(i) * components;
    if (batch.count < W) std::fill(to, to + components, Narrow<W>{});
    for (int lane = 0; lane < batch.count; ++lane)
      place[batch.first - chunk.begin + lane] = reinterpret_cast<float*>(to) + lane;
  }
  // Batches of cells that are projected, and of cells that are not, by turns.
  for (int i = chunk.batch_begin, last = i; i < chunk.batch_end; i = last) {
    const bool here = meets(plan_, block, plan_.batches()[index(i)], project);
    if (project.mixed())
      while (last < chunk.batch_end && meets(plan_, block, plan_.batches()[index(last)], project) == here) ++last;
    else
      last = chunk.batch_end;
    const int begin = plan_.batches()[index(i)].first;
    const int end = last < chunk.batch_end ? plan_.batches()[index(last)].first : chunk.end;
    for_each_material(plan_, block, begin, end, [&](std::uint16_t material, int first, std::size_t n) {
      const int at = first - chunk.begin;
      laws_[material]->grid_tangent({chunk.F + at, n}, {particles_.F.data() + first, n},
                                    {particles_.volume0.data() + first, n}, here, {place + at, n}, W);
    });
  }
}

template <int D>
void ElasticEnergy<D>::prepare_hessian(const Vector& u, const Projected& project) {
  tangent_ = memory_.tangents.take<Narrow<W>>(plan_.batches().size() * components);
  work_.tangent += particles_.size();
  if (barred()) return barred_tangents(u, project);
  for_each_block(plan_, parallel_, [&](const Block<D>& block, int) {
    for_each_deformed(block, u, [&](const Chunk& chunk) { chunk_tangents(block, chunk, project); });
  });
}

template <int D>
void ElasticEnergy<D>::hessian_product(const Vector& p, Vector& Hp) {
  constexpr int n2 = D * D;
  const bool coupled = barred();
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D, decltype(k)::dense>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int b) {
      double local[S::nodes * D], result[S::nodes * D] = {};
      load_block<D, K, D>(plan_, block, p.data(), local);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[index(i)];
        Wide<W> room[2 * D * K];
        const Wide<W>* const w = plan_.weights(i, room);
        const Narrow<W>* const A = tangent_ + index(i) * components;
        // The tangents are most of what comes from memory.
        constexpr int ahead = 2 * components * sizeof(Narrow<W>), line = 64;
        for (int byte = 0; byte < components * static_cast<int>(sizeof(Narrow<W>)); byte += line)
          __builtin_prefetch(reinterpret_cast<const char*>(A) + ahead + byte);
        Wide<W> gradient[D][D];
        S::template gather<false, true>(local + batch.node * D, w, w + S::values, nullptr, gradient);
        // Each number of the symmetric tangent is read once and used twice.
        Wide<W> flux[D][D] = {};
#pragma GCC unroll 9
        for (int row = 0; row < n2; ++row)
#pragma GCC unroll 9
          for (int column = row; column < n2; ++column) {
            const Wide<W> a = widen<W>(A[packed_tangent_index<D>(row, column)]);
            flux[row % D][row / D] += a * gradient[column % D][column / D];
            if (column != row) flux[column % D][column / D] += a * gradient[row % D][row / D];
          }
        S::template scatter<false, true>(nullptr, flux, w, w + S::values, result + batch.node * D);
      }
      if (coupled) couple<K>(b, local, result);
      add_block<D, K, D>(plan_, block, result, Hp.data());
    });
  });
  work_.hessian_product += particles_.size();
}

template class ElasticEnergy<2>;
template class ElasticEnergy<3>;

}  // namespace pf
