// Where particles will stand after a step, before anything of them is written: so that what the step computes of each
// goes to its new place at once.
#include <algorithm>
#include <atomic>

#include "core/grid/records.hpp"
#include "core/grid/stencil.hpp"

namespace pf {

namespace {

/// x_p + sum_j u_j N_j(x_p) of a block's particles.
template <int D, int K, bool Dense>
void move_block(const Plan<D>& plan, const Block<D>& block, const Vector& u, const Vec<D>* x, Vec<D>* to) {
  using S = Stencil<D, K, D, Dense>;
  using Lane = Wide<lane_count<D>>;
  double local[S::nodes * D];
  load_block<D, K, D>(plan, block, u.data(), local);
  for (int i = block.batch_begin; i < block.batch_end; ++i) {
    const Batch& batch = plan.batches()[static_cast<std::size_t>(i)];
    Lane room[2 * D * K], way[D], place[D];
    const Lane* const w = plan.weights(i, room);
    S::template gather<true, false>(local + batch.node * D, w, w, way, nullptr);
    load_lanes<D>(x[batch.first].data(), batch.count, place);
    for (int a = 0; a < D; ++a) place[a] += way[a];
    store_lanes<D>(place, batch.count, to[batch.first].data());
  }
}

}  // namespace

template <int D>
bool Plan<D>::order_movers() {
  const std::size_t n = key_.size();
  movers_.clear();
  for (std::size_t p = 0; p < n; ++p)
    if (next_key_[p] != key_[p]) movers_.push_back({next_key_[p], static_cast<std::uint32_t>(p)});
  // Those who stay are in order. Particles of one key keep the order that they had, as in a stable sort.
  std::sort(movers_.begin(), movers_.end(), [](const Mover& a, const Mover& b) {
    return a.key < b.key || (a.key == b.key && a.particle < b.particle);
  });
  order_.resize(n);
  place_of_.resize(n);
  std::uint32_t place = 0;
  const auto put = [&](std::uint32_t particle) {
    order_[place] = particle;
    place_of_[particle] = place++;
  };
  auto mover = movers_.begin();
  for (std::uint32_t p = 0; p < n; ++p) {
    if (next_key_[p] != key_[p]) continue;
    for (; mover != movers_.end() && (mover->key < key_[p] || (mover->key == key_[p] && mover->particle < p)); ++mover)
      put(mover->particle);
    put(p);
  }
  for (; mover != movers_.end(); ++mover) put(mover->particle);
  return !movers_.empty();
}

template <int D>
bool Plan<D>::foresee(const Particles<D>& particles, const Vector& u, Motion<D>& to, Parallel& parallel) {
  next_key_.resize(particles.size());
  next_keys_ = keys_;
  std::atomic<bool> all{true};
  with_nodes_per_axis(*this, [&](auto k) {
    for_each_block(*this, parallel, [&](const Block<D>& block, int) {
      move_block<D, k, decltype(k)::dense>(*this, block, u, particles.x.data(), to.x);
      const std::int32_t first = block.particle_begin;
      if (!cell_keys(keys_, to.x + first, particles.material.data() + first, block.particle_end - first,
                     next_key_.data() + first))
        all.store(false, std::memory_order_relaxed);
    });
  });
  bool moved = false;
  if (all) {
    moved = order_movers();
  } else {
    if (!make_keys(particles, to.x, next_keys_)) return false;
    cell_keys(next_keys_, to.x, particles.material.data(), static_cast<std::ptrdiff_t>(particles.size()),
              next_key_.data());
    moved = order_by(next_key_, next_keys_, to.spare, parallel);
  }
  to.place = moved ? place_of_.data() : nullptr;
  return true;
}

template <int D>
void Plan<D>::follow(Particles<D>& particles, const Motion<D>& moved, Parallel& parallel) {
  keys_ = next_keys_;
  if (moved.place)
    for (std::size_t i = 0; i < key_.size(); ++i) key_[i] = next_key_[order_[i]];
  else
    key_.swap(next_key_);
  adopt(particles, moved, parallel);
  make_tables(particles, parallel);
}

#define PF_INSTANTIATE(D)                                                                    \
  template bool Plan<D>::foresee(const Particles<D>&, const Vector&, Motion<D>&, Parallel&); \
  template bool Plan<D>::order_movers();                                                     \
  template void Plan<D>::follow(Particles<D>&, const Motion<D>&, Parallel&);
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
