// Particles in the order of the blocks and cells that they stand in.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/grid/plan.hpp"
#include "core/grid/records.hpp"
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
    // A block more on either side: keys last until a particle leaves it.
    keys.origin[a] = (first & ~static_cast<long long>(block_edge - 1)) - block_edge;
    keys.block_bits[a] = bits_for(static_cast<std::uint64_t>(last + block_edge - keys.origin[a]) >> edge_bits);
    bits += keys.block_bits[a];
  }
  std::uint16_t materials = 0;
  for (const std::uint16_t m : particles.material) materials = std::max(materials, m);
  keys.material_bits = materials == 0 ? 0 : bits_for(materials);
  keys.total_bits = bits + keys.material_bits;
  return keys.total_bits < 64;
}

template <int D>
bool Plan<D>::cell_keys(const Keys& keys, const Vec<D>* x, const std::uint16_t* material, std::ptrdiff_t count,
                        std::uint64_t* key) const {
  using Integers = Whole<W>;
  const double inverse = inverse_spacing_, offset = basis_->offset;
  Integers outside{};
  for (std::ptrdiff_t p = 0; p < count; p += W) {
    const int lanes = static_cast<int>(std::min<std::ptrdiff_t>(W, count - p));
    Wide<W> place[D];
    load_lanes<D>(x[p].data(), lanes, place);
    Integers base[D], here{};
    for (int a = 0; a < D; ++a) {
      const Wide<W> s = place[a] * inverse - offset;
      // Beyond what an integer holds, and what is not a number, has no key.
      const auto far = !(s < 4e18 && s > -4e18);
      const Wide<W> near = far ? Wide<W>{} : s;
      Integers down = __builtin_convertvector(near, Integers);
      down += __builtin_convertvector(down, Wide<W>) > near;  // a comparison that holds is -1
      base[a] = down;
      here |= far;
    }
    Integers k = keys.pack(base, here);
    if (lanes == W) {
      if (keys.material_bits > 0)
        for (int lane = 0; lane < W; ++lane) k[lane] |= material[p + lane];
      std::memcpy(key + p, &k, sizeof k);
      outside |= here;
    } else {
      for (int lane = 0; lane < lanes; ++lane) {
        key[p + lane] = static_cast<std::uint64_t>(k[lane]) | (keys.material_bits > 0 ? material[p + lane] : 0u);
        outside[0] |= here[lane];
      }
    }
  }
  std::int64_t any = 0;
  for (int lane = 0; lane < W; ++lane) any |= outside[lane];
  return any == 0;
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
bool Plan<D>::order_by(const std::vector<std::uint64_t>& key, const Keys& keys, Vec<D>* spare, Parallel& parallel) {
  const std::size_t n = key.size();
  if (std::is_sorted(key.begin(), key.end())) return false;
  order_.resize(n);
  place_of_.resize(n);
  std::iota(order_.begin(), order_.end(), 0u);
  // Two keys are no longer than a Vec.
  std::vector<Vec<D>> own(spare ? 0 : n);
  auto* const sorted = reinterpret_cast<std::uint64_t*>(spare ? spare : own.data());
  auto* const other = sorted + n;
  copy(key.data(), n, parallel, sorted);
  if (radix_sort(sorted, order_.data(), other, place_of_.data(), n, keys.total_bits)) order_.swap(place_of_);
  for (std::size_t i = 0; i < n; ++i) place_of_[order_[i]] = static_cast<std::uint32_t>(i);
  return true;
}

template <int D>
bool Plan<D>::build(Particles<D>& particles, const BasisInfo& basis, double spacing, Parallel& parallel) {
  basis_ = &basis;
  spacing_ = spacing;
  inverse_spacing_ = 1 / spacing;
  if (!make_keys(particles, particles.x.data(), keys_)) return false;
  const std::size_t n = particles.size();
  key_.resize(n);
  cell_keys(keys_, particles.x.data(), particles.material.data(), static_cast<std::ptrdiff_t>(n), key_.data());
  if (order_by(key_, keys_, nullptr, parallel)) {
    Particles<D> before = particles;
    const auto sorted = [&]<class T>(std::vector<T>& to, const std::vector<T>& from) {
      if (!from.empty()) gather(from.data(), order_, parallel, to.data());
    };
    sorted(particles.x, before.x);
    sorted(particles.v, before.v);
    sorted(particles.F, before.F);
    sorted(particles.C, before.C);
    sorted(particles.a, before.a);
    sorted(particles.X, before.X);
    sorted(particles.mass, before.mass);
    sorted(particles.volume0, before.volume0);
    sorted(particles.id, before.id);
    sorted(particles.body, before.body);
    sorted(particles.material, before.material);
    std::sort(key_.begin(), key_.end());
  }
  make_tables(particles, parallel);
  return true;
}

template <int D>
void Plan<D>::adopt(Particles<D>& particles, const Motion<D>& moved, Parallel& parallel) {
  const std::size_t n = particles.size();
  // What the step wrote stands in its new place already.
  const auto taken = [&]<class T>(std::vector<T>& values, const T* from, std::vector<T>* other) {
    if (other)
      values.swap(*other);
    else
      copy(from, n, parallel, values.data());
  };
  Particles<D>* const owner = moved.owner;
  taken(particles.v, moved.v, owner ? &owner->v : nullptr);
  taken(particles.F, moved.F, owner ? &owner->F : nullptr);
  if (moved.C) taken(particles.C, moved.C, owner ? &owner->C : nullptr);
  if (!moved.place) return taken(particles.x, moved.x, owner ? &owner->x : nullptr);
  gather(moved.x, order_, parallel, particles.x.data());
  const auto sorted = [&]<class T>(std::vector<T>& values) {
    if (values.empty()) return;
    T* const spare = reinterpret_cast<T*>(moved.spare);
    copy(values.data(), n, parallel, spare);
    gather(spare, order_, parallel, values.data());
  };
  sorted(particles.a);
  sorted(particles.mass);
  sorted(particles.volume0);
  sorted(particles.id);
  sorted(particles.body);
  if (keys_.material_bits > 0) sorted(particles.material);
  if (!owner) return sorted(particles.X);
  // Last: the owner's X is the room that the others were sorted in.
  gather(particles.X.data(), order_, parallel, owner->X.data());
  particles.X.swap(owner->X);
}

#define PF_INSTANTIATE(D)                                                                                            \
  template bool Plan<D>::build(Particles<D>&, const BasisInfo&, double, Parallel&);                                  \
  template bool Plan<D>::make_keys(const Particles<D>&, const Vec<D>*, Keys&) const;                                 \
  template bool Plan<D>::cell_keys(const Keys&, const Vec<D>*, const std::uint16_t*, std::ptrdiff_t, std::uint64_t*) \
      const;                                                                                                         \
  template bool Plan<D>::order_by(const std::vector<std::uint64_t>&, const Keys&, Vec<D>*, Parallel&);               \
  template void Plan<D>::adopt(Particles<D>&, const Motion<D>&, Parallel&);
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
