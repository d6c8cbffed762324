// The plan of a step: which particle meets which node with which weight. Weights depend on x_p^n only, so the
// plan is made once a step and serves every transfer, gradient and Hessian product (THEORY T4).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/bases/basis.hpp"
#include "core/grid/edges.hpp"
#include "core/grid/particles.hpp"
#include "core/grid/plan_keys.hpp"
#include "core/grid/wide.hpp"
#include "core/math/parallel.hpp"
#include "core/types.hpp"

namespace pf {

/// Up to lane_count<D> particles of one cell: they share their nodes.
struct Batch {
  std::int32_t first;  ///< particle
  std::int16_t count;
  std::int16_t node;  ///< the cell's first node in the block's own lattice
};

/// Consecutive particles of one material, for one call of its law: at most `longest_run`.
inline constexpr std::int32_t longest_run = 128;
struct MaterialRun {
  std::int32_t begin, end;
  std::uint16_t material;
};

/// 4^D cells and their (4 + K - 1)^D nodes. Blocks of one colour share no node.
template <int D>
struct Block {
  std::array<long long, D> corner;  ///< lattice coordinates of its first node
  std::int32_t batch_begin, batch_end;
  std::int32_t run_begin, run_end;
  std::int32_t particle_begin, particle_end;
  std::int32_t nodes;  ///< where its table starts in Plan::node_of
};

/// Which of the 4^D nodes of a block-sized piece of the lattice are active, and the number of the first.
template <int D>
struct NodeBlock {
  std::array<long long, D> corner;
  std::uint64_t active = 0;
  std::int32_t first = 0;
};

template <int D>
class Plan {
 public:
  static constexpr int W = lane_count<D>;

  /// Sorts `particles` by block and cell (their order changes; ids stay), numbers the active nodes and computes the
  /// weights. False when a position is not finite or the particles are too far apart to be indexed.
  bool build(Particles<D>& particles, const BasisInfo& basis, double spacing, Parallel& parallel);

  /// Before the particles move with the nodes: to.x becomes x_p + sum_j u_j N_j(x_p) (THEORY T5), to.place the order
  /// that follow() will put them in, null if it is the present one. The plan stays what it is. False as of build().
  bool foresee(const Particles<D>& particles, const Vector& u, Motion<D>& to, Parallel& parallel);
  /// The plan of particles that have moved as foreseen: they become what `moved` holds, in the order foreseen.
  void follow(Particles<D>& particles, const Motion<D>& moved, Parallel& parallel);

  /// What the particles stood for at first, for bases that average over domains. For the next build.
  struct Domains {
    std::vector<double> edge_of_body;  ///< of cubes [m]; none, or 0: as large as the particle
    std::vector<Mat<D>> of_id;         ///< edges of a parallelepiped as columns [m]; none, or zero: a cube
  };
  void set_domains(Domains domains) { domains_ = std::move(domains); }
  /// Walls that are planes of nodes, of each axis; for the next build. Ignored while a particle is more than half a
  /// cell behind one, which edges_left() then tells.
  void set_edges(const std::array<EdgePlanes, D>& edges) { wanted_edges_ = edges; }
  bool edges_left() const { return edges_left_; }
  /// How many domains are too large for their nodes and were shrunk (core/grid/domain.hpp).
  int shrunk_domains() const { return shrunk_; }

  /// How many plans have been made of this object: what belongs to one belongs to no other.
  std::int64_t made() const { return made_; }
  int nodes_per_axis() const { return basis_->nodes_per_axis; }
  const BasisInfo& basis() const { return *basis_; }
  double spacing() const { return spacing_; }
  int node_count() const { return node_count_; }
  const std::array<long long, D>& node_index(int node) const { return index_[static_cast<std::size_t>(node)]; }
  const std::vector<std::array<long long, D>>& node_indices() const { return index_; }
  /// The node's own place x_i [m].
  Vec<D> node_position(int node) const {
    Vec<D> x;
    for (int a = 0; a < D; ++a) x[a] = spacing_ * static_cast<double>(node_index(node)[static_cast<std::size_t>(a)]);
    return x;
  }
  const EdgePlanes& edges(int axis) const { return edges_[static_cast<std::size_t>(axis)]; }
  /// Weights of each node by itself (core/grid/dense_stencil.hpp), not as products of the axes'.
  bool dense() const { return basis_->averaged(); }
  /// Whether D_p = sum N (x_i - x_p)(x)(x_i - x_p) is what BasisInfo says for every particle.
  bool regular() const { return !dense() && !ended_; }

  const std::vector<Block<D>>& blocks() const { return blocks_; }
  const std::vector<Batch>& batches() const { return batches_; }
  const std::vector<MaterialRun>& runs() const { return runs_; }
  /// Block indices by colour, 2^D lists.
  const std::array<std::vector<int>, 1 << D>& colours() const { return colours_; }
  /// Global node of each node of the block's lattice, x fastest; -1 where the node is not active. With dense weights a
  /// cell's node may be inactive: no particle's domain reaches it.
  const std::int32_t* node_table(const Block<D>& block) const { return node_of_.data() + block.nodes; }
  /// Weights of a batch: for each axis K values N, then for each axis K values dN/dx [1/m]; a lane a particle;
  /// any finite numbers in the lanes beyond count. In 3D computed anew, in `room` for 2 D K, from where the particles
  /// stand in their cell: that is quicker than fetching six times as many numbers from memory. In 2D, where all else is
  /// as little work, they are kept as long as a cache may hold them, as are those that are not the spline's own. Dense
  /// weights: see there.
  const Wide<W>* weights(int batch, Wide<W>* room) const {
    if (stride_ > 0) return kept_.data() + static_cast<std::ptrdiff_t>(batch) * stride_;
    compute_weights(batch, room);
    return room;
  }
  /// The active node at these lattice coordinates, or -1.
  int find_node(const std::array<long long, D>& index) const;
  std::size_t bytes() const;

 private:
  using Keys = PlanKeys<D>;
  bool make_keys(const Particles<D>& particles, const Vec<D>* x, Keys& keys) const;
  bool cell_keys(const Keys& keys, const Vec<D>* x, const std::uint16_t* material, std::ptrdiff_t count,
                 std::uint64_t* key) const;
  bool order_by(const std::vector<std::uint64_t>& key, const Keys& keys, Vec<D>* spare, Parallel& parallel);
  bool order_movers();
  void adopt(Particles<D>& particles, const Motion<D>& moved, Parallel& parallel);
  void make_tables(const Particles<D>& particles, Parallel& parallel);
  void make_blocks(const Particles<D>& particles);
  void number_nodes();
  void place(const Particles<D>& particles, Parallel& parallel);
  void choose_edges(const Particles<D>& particles);
  void average(const Particles<D>& particles, int batch, Wide<W>* w, int& shrunk) const;
  void end_edges(const std::array<long long, D>& first, Wide<W>* w) const;
  /// Nodes of the cell that dense weights of a batch reach.
  std::uint64_t reached(int batch) const;
  static constexpr std::size_t most_kept = std::size_t{8} << 20;  ///< bytes
  void compute_weights(int batch, Wide<W>* w) const {
    const int n = D * basis_->nodes_per_axis;
    const Wide<W>* const t = place_.data() + static_cast<std::ptrdiff_t>(batch) * D;
    if constexpr (W == 4)
      basis_->four(t, w, w + n);
    else
      basis_->eight(t, w, w + n);
    const auto inverse = spread<Wide<W>>(inverse_spacing_);
    for (int k = n; k < 2 * n; ++k) w[k] *= inverse;
  }

  const BasisInfo* basis_ = nullptr;
  double spacing_ = 0, inverse_spacing_ = 0;
  int node_count_ = 0;
  std::int64_t made_ = 0;
  std::vector<std::array<long long, D>> index_;
  std::vector<NodeBlock<D>> node_blocks_;        ///< sorted by corner
  std::vector<std::array<int, 1 << D>> around_;  ///< each block's node blocks
  std::vector<Block<D>> blocks_;
  std::vector<Batch> batches_;
  std::vector<MaterialRun> runs_;
  std::array<std::vector<int>, 1 << D> colours_;
  std::vector<std::int32_t> node_of_;
  std::vector<Wide<W>> place_;  ///< x / dx - base of each axis, D a batch
  std::vector<Wide<W>> kept_;   ///< weights: in 2D, at walls and of domains
  std::ptrdiff_t stride_ = 0;   ///< kept weights a batch; 0: none are kept
  std::array<EdgePlanes, D> wanted_edges_{}, edges_{};
  bool ended_ = false, edges_left_ = false;
  Domains domains_;
  const Mat<D>* domain_of(std::uint32_t id) const {
    const bool own = id < domains_.of_id.size() && !domains_.of_id[id].isZero(0);
    return own ? &domains_.of_id[id] : nullptr;
  }
  int shrunk_ = 0;
  Keys keys_, next_keys_;
  std::vector<std::uint64_t> key_;  ///< of each particle, ascending
  // What foresee() finds out.
  std::vector<std::uint64_t> next_key_;
  std::vector<std::uint32_t> order_, place_of_;  ///< which particle comes to a place, and the other way round
  struct Mover {
    std::uint64_t key;
    std::uint32_t particle;
  };
  std::vector<Mover> movers_;
};

extern template class Plan<2>;
extern template class Plan<3>;

}  // namespace pf
