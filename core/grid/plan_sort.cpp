// Particles in the order of the blocks and cells that they stand in.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/grid/plan_keys.hpp"
#include "core/math/vector_ops.hpp"

namespace pf {

namespace {

/// Bits that hold any value in [0, n].
int bits_for(std::uint64_t n) {
  return std::max(1, static_cast<int>(std::bit_width(n)));
}

}  // namespace

template <int D>
bool Plan<D>::make_keys(const Particles<D>& particles, const Vec<D>* positions, Keys& keys) const {
  const double inverse = 1 / spacing_;
  std::array<double, D> low{}, high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t p = 0; p < particles.size(); ++p)
    for (int a = 0; a < D; ++a) {
      const auto k = static_cast<std::size_t>(a);
      const double x = positions[p][a];
      if (!std::isfinite(x)) return false;
      low[k] = std::min(low[k], x);
      high[k] = std::max(high[k], x);
    }
  int bits = D * edge_bits;
  double N[max_nodes_per_axis], dN[max_nodes_per_axis];
  for (std::size_t a = 0; a < D; ++a) {
    if (std::max(std::abs(low[a]), std::abs(high[a])) * inverse > 1e15) return false;
    long long first = 0, last = 0;
    basis_->weights(low[a] * inverse, first, N, dN);
    basis_->weights(high[a] * inverse, last, N, dN);
    // A cell more on either side: rounding may place a particle on a cell's face differently elsewhere.
    keys.origin[a] = (first - 1) & ~static_cast<long long>(block_edge - 1);
    keys.block_bits[a] = bits_for(static_cast<std::uint64_t>(last + 1 - keys.origin[a]) >> edge_bits);
    bits += keys.block_bits[a];
  }
  std::uint16_t materials = 0;
  for (const std::uint16_t m : particles.material) materials = std::max(materials, m);
  keys.material_bits = materials == 0 ? 0 : bits_for(materials);
  keys.total_bits = bits + keys.material_bits;
  return keys.total_bits < 64;
}

namespace {

/// Stable sort of `n` pairs (key, order) by the low `bits` of key: least significant digit first. Returns whether the
/// result is in the scratch arrays.
bool radix_sort(std::uint64_t* key, std::uint32_t* order, std::uint64_t* key_scratch, std::uint32_t* order_scratch,
                std::size_t n, int bits) {
  constexpr int digit = 11;
  bool swapped = false;
  for (int shift = 0; shift < bits; shift += digit) {
    std::array<std::uint32_t, (1u << digit) + 1> start{};
    for (std::size_t i = 0; i < n; ++i) ++start[((key[i] >> shift) & ((1u << digit) - 1)) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t to = start[(key[i] >> shift) & ((1u << digit) - 1)]++;
      key_scratch[to] = key[i];
      order_scratch[to] = order[i];
    }
    std::swap(key, key_scratch);
    std::swap(order, order_scratch);
    swapped = !swapped;
  }
  return swapped;
}

/// to[i] = from[order[i]].
template <class T>
void gather(const T* from, const std::vector<std::uint32_t>& order, Parallel& parallel, T* to) {
  for_pieces(parallel, static_cast<std::ptrdiff_t>(order.size()), [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = begin; i < begin + count; ++i) to[i] = from[order[static_cast<std::size_t>(i)]];
  });
}
template <class T>
void copy(const T* from, std::size_t n, Parallel& parallel, T* to) {
  for_pieces(parallel, static_cast<std::ptrdiff_t>(n),
             [&](std::ptrdiff_t begin, std::ptrdiff_t count) { std::copy_n(from + begin, count, to + begin); });
}

}  // namespace

template <int D>
void Plan<D>::permute(Particles<D>& particles, const Motion<D>& moved, Parallel& parallel) const {
  const std::size_t n = particles.size();
  std::vector<Mat<D>> own(moved.spare ? 0 : n);
  void* const spare = moved.spare ? static_cast<void*>(moved.spare) : own.data();
  const auto sorted = [&]<class T>(std::vector<T>& values, const T* from) {
    if (from == values.data()) {
      copy(from, n, parallel, static_cast<T*>(spare));
      from = static_cast<const T*>(spare);
    }
    gather(from, order_, parallel, values.data());
  };
  sorted(particles.x, moved.x);
  sorted(particles.v, moved.v);
  sorted(particles.F, moved.F);
  if (moved.C) sorted(particles.C, moved.C);
  if (!particles.a.empty()) sorted(particles.a, particles.a.data());
  sorted(particles.X, particles.X.data());
  sorted(particles.mass, particles.mass.data());
  sorted(particles.volume0, particles.volume0.data());
  sorted(particles.id, particles.id.data());
  sorted(particles.body, particles.body.data());
  sorted(particles.material, particles.material.data());
}

template <int D>
void Plan<D>::sort(Particles<D>& particles, const Motion<D>& moved, Keys& keys, Parallel& parallel) {
  const std::size_t n = particles.size();
  const double inverse = 1 / spacing_;
  key_.resize(n);
  order_.resize(n);
  const double offset = basis_->offset;
  bool sorted = true;
  for (std::size_t p = 0; p < n; ++p) {
    std::array<long long, D> base{};
    for (int a = 0; a < D; ++a)
      base[static_cast<std::size_t>(a)] = static_cast<long long>(std::floor(moved.x[p][a] * inverse - offset));
    key_[p] = keys.pack(base, particles.material[p]);
    sorted = sorted && (p == 0 || key_[p - 1] <= key_[p]);
  }
  if (sorted) {
    if (moved.x == particles.x.data()) return;
    copy(moved.x, n, parallel, particles.x.data());
    copy(moved.v, n, parallel, particles.v.data());
    copy(moved.F, n, parallel, particles.F.data());
    if (moved.C) copy(moved.C, n, parallel, particles.C.data());
    return;
  }
  std::iota(order_.begin(), order_.end(), 0u);
  // A key and an index are no longer than a Vec.
  std::vector<Vec<D>> own(moved.spare ? 0 : n);
  auto* const other_key = reinterpret_cast<std::uint64_t*>(moved.spare ? moved.spare : own.data());
  auto* const other_order = reinterpret_cast<std::uint32_t*>(other_key + n);
  if (radix_sort(key_.data(), order_.data(), other_key, other_order, n, keys.total_bits)) {
    copy(other_key, n, parallel, key_.data());
    copy(other_order, n, parallel, order_.data());
  }
  permute(particles, moved, parallel);
}

template <int D>
bool Plan<D>::can_index(const Particles<D>& particles, const Vec<D>* x) const {
  Keys keys;
  return make_keys(particles, x, keys);
}

#define PF_INSTANTIATE(D)                                                            \
  template void Plan<D>::permute(Particles<D>&, const Motion<D>&, Parallel&) const;  \
  template bool Plan<D>::make_keys(const Particles<D>&, const Vec<D>*, Keys&) const; \
  template void Plan<D>::sort(Particles<D>&, const Motion<D>&, Keys&, Parallel&);    \
  template bool Plan<D>::can_index(const Particles<D>&, const Vec<D>*) const;
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
