#include "core/grid/plan.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "core/grid/domain.hpp"
#include "core/grid/records.hpp"

namespace pf {

template <int D>
void Plan<D>::make_blocks(const Particles<D>& particles) {
  const Keys& keys = keys_;
  const int edge_nodes = block_edge + nodes_per_axis() - 1;
  blocks_.clear();
  batches_.clear();
  runs_.clear();
  for (auto& list : colours_) list.clear();
  const auto n = static_cast<std::int32_t>(particles.size());
  for (std::int32_t begin = 0; begin < n;) {
    const std::uint64_t block_key = keys.block_of(key_[static_cast<std::size_t>(begin)]);
    Block<D> block{};
    block.corner = keys.corner(block_key);
    block.particle_begin = begin;
    block.batch_begin = static_cast<std::int32_t>(batches_.size());
    block.run_begin = static_cast<std::int32_t>(runs_.size());
    std::int32_t p = begin;
    while (p < n && keys.block_of(key_[static_cast<std::size_t>(p)]) == block_key) {
      const std::uint64_t cell = keys.cell_of(key_[static_cast<std::size_t>(p)]);
      Batch batch{p, 0, 0};
      for (int a = D - 1; a >= 0; --a)
        batch.node = static_cast<std::int16_t>(batch.node * edge_nodes +
                                               static_cast<int>(cell >> (a * edge_bits) & (block_edge - 1)));
      while (p < n && batch.count < W && keys.block_of(key_[static_cast<std::size_t>(p)]) == block_key &&
             keys.cell_of(key_[static_cast<std::size_t>(p)]) == cell) {
        const std::uint16_t material = particles.material[static_cast<std::size_t>(p)];
        if (static_cast<std::int32_t>(runs_.size()) == block.run_begin || runs_.back().material != material ||
            p - runs_.back().begin >= longest_run)
          runs_.push_back({p, p, material});
        runs_.back().end = ++p;
        ++batch.count;
      }
      batches_.push_back(batch);
    }
    block.particle_end = begin = p;
    block.batch_end = static_cast<std::int32_t>(batches_.size());
    block.run_end = static_cast<std::int32_t>(runs_.size());
    int colour = 0;
    for (std::size_t a = 0; a < D; ++a) colour |= static_cast<int>(block.corner[a] >> edge_bits & 1) << a;
    colours_[static_cast<std::size_t>(colour)].push_back(static_cast<int>(blocks_.size()));
    blocks_.push_back(block);
  }
}

namespace {

template <int D>
bool lexicographic(const std::array<long long, D>& a, const std::array<long long, D>& b) {
  for (int k = D - 1; k >= 0; --k)
    if (a[static_cast<std::size_t>(k)] != b[static_cast<std::size_t>(k)])
      return a[static_cast<std::size_t>(k)] < b[static_cast<std::size_t>(k)];
  return false;
}

/// `result` becomes the node blocks that the blocks touch, sorted.
template <int D>
void node_blocks_of(const std::vector<Block<D>>& blocks, std::vector<NodeBlock<D>>& result) {
  result.clear();
  result.reserve(blocks.size() << D);
  for (const Block<D>& block : blocks)
    for (int o = 0; o < 1 << D; ++o) {
      NodeBlock<D> nb{block.corner};
      for (std::size_t a = 0; a < D; ++a) nb.corner[a] += (o >> a & 1) * block_edge;
      result.push_back(nb);
    }
  const auto less = [](const NodeBlock<D>& a, const NodeBlock<D>& b) { return lexicographic<D>(a.corner, b.corner); };
  std::sort(result.begin(), result.end(), less);
  result.erase(std::unique(result.begin(), result.end(),
                           [](const NodeBlock<D>& a, const NodeBlock<D>& b) { return a.corner == b.corner; }),
               result.end());
}

/// Where a block's 2^D node blocks stand in the sorted list.
template <int D>
std::array<int, 1 << D> neighbours(const std::vector<NodeBlock<D>>& node_blocks, const Block<D>& block) {
  std::array<int, 1 << D> found{};
  for (int o = 0; o < 1 << D; ++o) {
    std::array<long long, D> corner = block.corner;
    for (std::size_t a = 0; a < D; ++a) corner[a] += (o >> a & 1) * block_edge;
    const auto at = std::lower_bound(
        node_blocks.begin(), node_blocks.end(), corner,
        [](const NodeBlock<D>& nb, const std::array<long long, D>& c) { return lexicographic<D>(nb.corner, c); });
    found[static_cast<std::size_t>(o)] = static_cast<int>(at - node_blocks.begin());
  }
  return found;
}

/// Nodes of a block's lattice, for the most that a basis has.
constexpr int most_edge = block_edge + max_nodes_per_axis - 1, most_table = most_edge * most_edge * most_edge;

/// Splits a node of a block's lattice into node block (of the 2^D) and slot in it (of the 4^D).
template <int D>
std::pair<int, int> split(int node, int edge_nodes) {
  int which = 0, slot = 0;
  for (int a = 0; a < D; ++a) {
    const int k = node % edge_nodes;
    node /= edge_nodes;
    which |= (k >> edge_bits) << a;
    slot |= (k & (block_edge - 1)) << (a * edge_bits);
  }
  return {which, slot};
}

}  // namespace

template <int D>
void Plan<D>::number_nodes() {
  const int K = nodes_per_axis(), edge_nodes = block_edge + K - 1;
  const int table_size = D == 2 ? edge_nodes * edge_nodes : edge_nodes * edge_nodes * edge_nodes;
  std::vector<NodeBlock<D>>& node_blocks = node_blocks_;
  node_blocks_of(blocks_, node_blocks);
  node_of_.assign(blocks_.size() * static_cast<std::size_t>(table_size), -1);
  std::vector<std::array<int, 1 << D>>& around = around_;
  around.resize(blocks_.size());
  std::array<std::pair<int, int>, most_table> parts;
  for (int i = 0; i < table_size; ++i) parts[static_cast<std::size_t>(i)] = split<D>(i, edge_nodes);
  // Mark.
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    Block<D>& block = blocks_[b];
    block.nodes = static_cast<std::int32_t>(b * static_cast<std::size_t>(table_size));
    around[b] = neighbours(node_blocks, block);
    std::int32_t* table = node_of_.data() + block.nodes;
    int previous = -1;
    for (int i = block.batch_begin; i < block.batch_end; ++i) {
      const int base = batches_[static_cast<std::size_t>(i)].node;
      if (base == previous && !dense()) continue;
      previous = base;
      const std::uint64_t used = dense() ? reached(i) : ~std::uint64_t{0};
      for (int n = 0, z = 0; z < (D == 3 ? K : 1); ++z)
        for (int y = 0; y < K; ++y)
          for (int x = 0; x < K; ++x, ++n)
            if (used >> n & 1) table[base + x + edge_nodes * (y + edge_nodes * z)] = 0;
    }
    for (int i = 0; i < table_size; ++i)
      if (table[i] == 0) {
        const auto [which, slot] = parts[static_cast<std::size_t>(i)];
        node_blocks[static_cast<std::size_t>(around[b][static_cast<std::size_t>(which)])].active |= 1ull << slot;
      }
  }
  // Number, in the order of the node blocks.
  node_count_ = 0;
  index_.clear();
  for (NodeBlock<D>& nb : node_blocks) {
    nb.first = node_count_;
    for (int slot = 0; slot < 1 << (D * edge_bits); ++slot)
      if (nb.active >> slot & 1) {
        std::array<long long, D> at = nb.corner;
        for (std::size_t a = 0; a < D; ++a) at[a] += slot >> (static_cast<int>(a) * edge_bits) & (block_edge - 1);
        index_.push_back(at);
        ++node_count_;
      }
  }
  // Look up.
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    std::int32_t* table = node_of_.data() + blocks_[b].nodes;
    for (int i = 0; i < table_size; ++i) {
      if (table[i] < 0) continue;
      const auto [which, slot] = parts[static_cast<std::size_t>(i)];
      const NodeBlock<D>& nb = node_blocks[static_cast<std::size_t>(around[b][static_cast<std::size_t>(which)])];
      table[i] = nb.first + std::popcount(nb.active & ((1ull << slot) - 1));
    }
  }
}

namespace {

/// x / dx, rounded as a number of its own: fused with what follows, a particle on a cell's face would stand beside it.
template <class Lane>
__attribute__((noinline)) Lane in_cells(const Lane& x, double inverse) {
  return x * inverse;
}

}  // namespace

template <int D>
void Plan<D>::place(const Particles<D>& particles, Parallel& parallel) {
  const int K = nodes_per_axis(), edge = block_edge + K - 1;
  const int dense_stride = (D + 1) * (D == 2 ? K * K : K * K * K);
  const bool kept =
      ended_ || (D == 2 && batches_.size() * 2 * D * static_cast<std::size_t>(K) * sizeof(Wide<W>) <= most_kept);
  stride_ = dense() ? dense_stride : kept ? 2 * D * K : 0;
  place_.resize(batches_.size() * D);
  kept_.resize(batches_.size() * static_cast<std::size_t>(stride_));
  std::vector<int> shrunk(dense() ? blocks_.size() : 0);
  parallel(static_cast<int>(blocks_.size()), [&](int b) {
    const Block<D>& block = blocks_[static_cast<std::size_t>(b)];
    for (int i = block.batch_begin; i < block.batch_end; ++i) {
      const Batch& batch = batches_[static_cast<std::size_t>(i)];
      Wide<W> x[D];
      load_lanes<D>(particles.x[static_cast<std::size_t>(batch.first)].data(), batch.count, x);
      int node = batch.node;
      std::array<long long, D> first;
      for (int a = 0; a < D; ++a, node /= edge) {
        // All particles of a batch have the same first node.
        first[static_cast<std::size_t>(a)] = block.corner[static_cast<std::size_t>(a)] + node % edge;
        Wide<W> t = in_cells(x[a], inverse_spacing_) - static_cast<double>(first[static_cast<std::size_t>(a)]);
        t = t < basis_->offset ? Wide<W>{} + basis_->offset : t;
        t = t > basis_->offset + 1 ? Wide<W>{} + (basis_->offset + 1) : t;
        place_[static_cast<std::size_t>(i * D + a)] = t;
      }
      if (stride_ == 0) continue;
      Wide<W>* const w = kept_.data() + i * stride_;
      if (dense())
        average(particles, i, w, shrunk[static_cast<std::size_t>(b)]);
      else
        compute_weights(i, w);
      if (ended_) end_edges(first, w);
    }
  });
  shrunk_ = std::accumulate(shrunk.begin(), shrunk.end(), 0);
}

template <int D>
void Plan<D>::average(const Particles<D>& particles, int i, Wide<W>* w, int& shrunk) const {
  const Batch& batch = batches_[static_cast<std::size_t>(i)];
  const auto p = static_cast<std::size_t>(batch.first);
  Wide<W> edge[D * D];
  load_lanes<D * D>(particles.F[p].data(), batch.count, edge);
  Wide<W> l_0{};
  for (int lane = 0; lane < batch.count; ++lane) {
    const std::size_t q = p + static_cast<std::size_t>(lane), body = particles.body[q];
    const double known = body < domains_.edge_of_body.size() ? domains_.edge_of_body[body] : 0;
    l_0[lane] = known > 0 ? known : std::pow(particles.volume0[q], 1.0 / D);
    const Mat<D>* const own = domain_of(particles.id[q]);
    if (!own) continue;
    l_0[lane] = 1;
    const Mat<D> e = particles.F[q] * *own;
    for (int k = 0; k < D * D; ++k) edge[k][lane] = e(k);
  }
  for (Wide<W>& e : edge) e *= l_0 * inverse_spacing_;
  domain_weights<D>(*basis_, place_.data() + static_cast<std::ptrdiff_t>(i) * D, edge, batch.count, w, shrunk);
  const int nodes = static_cast<int>(stride_) / (D + 1);
  for (int k = nodes; k < stride_; ++k) w[k] *= inverse_spacing_;
}

template <int D>
std::uint64_t Plan<D>::reached(int batch) const {
  const Wide<W>* const w = kept_.data() + batch * stride_;
  const int nodes = static_cast<int>(stride_) / (D + 1), count = batches_[static_cast<std::size_t>(batch)].count;
  std::uint64_t used = 0;
  for (int k = 0; k < stride_; ++k)
    for (int lane = 0; lane < count; ++lane)
      if (w[k][lane] != 0) used |= std::uint64_t{1} << (k % nodes);
  return used;
}

template <int D>
void Plan<D>::end_edges(const std::array<long long, D>& first, Wide<W>* w) const {
  const int K = nodes_per_axis();
  for (int a = 0, step = 1; a < D; ++a, step *= K) {
    const auto s = static_cast<std::size_t>(a);
    if (!edges_[s].any()) continue;
    if (!dense()) {
      end_at_walls(K, edges_[s], first[s], 1, w + a * K);
      end_at_walls(K, edges_[s], first[s], 1, w + (D + a) * K);
      continue;
    }
    for (int n = 0; n < stride_; ++n)  // every line of nodes along the axis
      if (n / step % K == 0) end_at_walls(K, edges_[s], first[s], step, w + n);
  }
}

template <int D>
void Plan<D>::choose_edges(const Particles<D>& particles) {
  edges_ = {};
  ended_ = edges_left_ = false;
  for (std::size_t a = 0; a < D; ++a) {
    const EdgePlanes& wanted = wanted_edges_[a];
    if (!wanted.any() || !basis_->bends) continue;
    double low = 1e300, high = -1e300;
    for (const Vec<D>& x : particles.x) {
      low = std::min(low, x[static_cast<int>(a)]);
      high = std::max(high, x[static_cast<int>(a)]);
    }
    const bool inside = (!wanted.low || low * inverse_spacing_ >= static_cast<double>(*wanted.low) - 0.5) &&
                        (!wanted.high || high * inverse_spacing_ <= static_cast<double>(*wanted.high) + 0.5);
    if (inside)
      edges_[a] = wanted;
    else
      edges_left_ = true;
    ended_ = ended_ || inside;
  }
}

template <int D>
void Plan<D>::make_tables(const Particles<D>& particles, Parallel& parallel) {
  ++made_;
  make_blocks(particles);
  choose_edges(particles);
  place(particles, parallel);
  number_nodes();
}

template <int D>
int Plan<D>::find_node(const std::array<long long, D>& index) const {
  std::array<long long, D> corner = index;
  int slot = 0;
  for (std::size_t a = 0; a < D; ++a) {
    corner[a] &= ~static_cast<long long>(block_edge - 1);
    slot |= static_cast<int>(index[a] - corner[a]) << (static_cast<int>(a) * edge_bits);
  }
  const auto nb = std::lower_bound(
      node_blocks_.begin(), node_blocks_.end(), corner,
      [](const NodeBlock<D>& block, const std::array<long long, D>& c) { return lexicographic<D>(block.corner, c); });
  if (nb == node_blocks_.end() || nb->corner != corner || !(nb->active >> slot & 1)) return -1;
  return nb->first + std::popcount(nb->active & ((1ull << slot) - 1));
}

template <int D>
std::size_t Plan<D>::bytes() const {
  return (place_.size() + kept_.size()) * sizeof(Wide<W>) + node_of_.size() * 4 + batches_.size() * sizeof(Batch) +
         index_.size() * sizeof(index_[0]) + (key_.size() + next_key_.size()) * 8 +
         (order_.size() + place_of_.size()) * 4;
}

template class Plan<2>;
template class Plan<3>;

}  // namespace pf
