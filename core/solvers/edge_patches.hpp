// What a smoother needs beside Gauss-Seidel where splines hardly reach into the body.
#pragma once

#include <vector>

#include "core/math/parallel.hpp"
#include "core/math/stencil_matrix.hpp"

namespace pf {

/// At faces, edges and corners of a body some splines overlap but a few particles. Each alone is well scaled by its
/// diagonal block, but within that overlap it is nearly a sum of its neighbours: Gauss-Seidel hardly converges there,
/// and the more of them the slower CG becomes. So each such *light* node is solved for together with the nodes that it
/// is coupled with strongly, one patch after the other (multiplicative Schwarz smoothing: de Prenter, Verhoosel, van
/// Brummelen, Evans, Messe, Benzaken and Maute 2019, "Multigrid solvers for immersed finite element methods and
/// immersed isogeometric analysis"). Nothing but the matrix is looked at. Vectors hold D floats a slot of its layout.
template <int D>
class EdgePatches {
 public:
  /// A node is light where the trace of its diagonal block is less than this part of a neighbour's.
  static constexpr float light = 0.02f;
  /// Nodes i and j are coupled strongly where |A_ij| is more than this part of sqrt(tr A_ii tr A_jj).
  static constexpr float strong = 0.1f;

  /// Finds the light nodes of A and inverts their patches. Light nodes that an earlier patch holds get none.
  void build(const StencilMatrix<D>& A, Parallel& parallel);
  void clear();

  /// x: patch after patch, from one with rest = A x - b; keeps both up to date.
  void sweep(Parallel& parallel, Floats& x, Floats& rest) const;
  /// The adjoint, for A x = b.
  void sweep_back(Parallel& parallel, const Floats& b, Floats& x) const;

  /// Multiply-adds of both sweeps, and of build().
  std::uint64_t sweep_operations() const { return sweep_operations_; }
  std::uint64_t build_operations() const { return build_operations_; }

 private:
  struct Patch {
    std::size_t begin = 0, end = 0;  ///< its nodes: places in members_
    std::size_t inverse = 0;         ///< of its matrix: place in inverses_, column-major
    std::int32_t slab = 0;
    int nodes() const { return static_cast<int>(end - begin); }
  };

  template <int R>
  void find_light(const StencilMatrix<D>& A, Parallel& parallel);
  template <int R>
  void choose(const StencilMatrix<D>& A);
  template <int R>
  void copy_rows(const StencilMatrix<D>& A, Parallel& parallel);
  template <int R>
  void invert(const Patch& patch);
  void count(int row_entries);
  /// A patch's p-th node: which copied row it is, and its slot.
  std::int32_t place_of(const Patch& patch, int p) const { return members_[patch.begin + static_cast<std::size_t>(p)]; }
  std::int32_t slot_of(const Patch& patch, int p) const { return slot_[static_cast<std::size_t>(place_of(patch, p))]; }
  /// Where a vector holds its values.
  std::ptrdiff_t vector_place(const Patch& patch, int p) const {
    return static_cast<std::ptrdiff_t>(slot_of(patch, p)) * D;
  }
  /// way = inverse force, and x by as much.
  template <int R>
  void solve(const Patch& patch, const float* force, Floats& x, float* way) const;
  template <int R>
  void relax(const Patch& patch, Floats& x, Floats& rest) const;
  template <int R>
  void relax_back(const Patch& patch, const Floats& b, Floats& x) const;
  /// body(patch) for all patches of the slabs of one parity, in order or from the last.
  template <class Body>
  void for_patches(Parallel& parallel, int parity, bool forward, Body&& body) const;

  int reach_ = 0;
  std::vector<LatticePoint<D>> points_;  ///< of A's rows
  std::vector<float> traces_;            ///< of the diagonal blocks, a slot each
  std::vector<std::uint8_t> marks_;      ///< of A's rows: light
  std::vector<std::int32_t> place_;      ///< of A's rows among those copied; -1 where none needs it
  std::vector<std::int32_t> copied_;     ///< which rows those are
  std::vector<std::int32_t> slot_;       ///< of a copied row
  std::vector<std::int32_t> windows_;    ///< of a copied row: both halves of the stencil
  Floats rows_, inverses_;
  std::vector<std::int32_t> members_;    ///< places
  std::vector<Patch> patches_;           ///< by slab
  std::vector<std::size_t> slab_begin_;  ///< into patches_
  std::uint64_t sweep_operations_ = 0, build_operations_ = 0;
};

extern template class EdgePatches<2>;
extern template class EdgePatches<3>;

}  // namespace pf
