// The mass matrix of the grid (THEORY T3): lumped m_i = sum_p m_p N_i, or consistent M_ij = sum_p m_p N_i N_j, applied
// through the particles and never stored.
#pragma once

#include "core/grid/ghost_penalty.hpp"
#include "core/grid/plan.hpp"
#include "core/math/block_matrix.hpp"
#include "core/step_report.hpp"

namespace pf {

/// Part of the lumped matrix that a singular consistent one is blended with; measured in docs/mass-matrix.md.
inline constexpr double singular_blend = 0.05;

/// Which mass matrix.
struct MassKind {
  bool consistent = false;
  double ghost_penalty = 0;  ///< gamma of core/grid/ghost_penalty.hpp, of the consistent one; 0: none
};

/// What a MassMatrix computes with; kept between steps for its memory alone.
template <int D>
struct MassMemory {
  Vector diagonal, scale, r, Mp, z, p;
  GhostPenalty<D> ghost;
};

template <int D>
class MassMatrix {
 public:
  /// `lumped`: m_i, one a node. All are referred to, and `memory` where it is given.
  MassMatrix(const Plan<D>& plan, const Particles<D>& particles, const Vector& lumped, const MassKind& kind,
             Parallel& parallel, Work& work, MassMemory<D>* memory = nullptr);
  MassMatrix(const MassMatrix&) = delete;

  bool consistent() const { return consistent_; }
  /// b of (1 - b) M + b lumped: 0 unless M is consistent and singular. M is a sum of one rank-one matrix a particle, so
  /// with fewer particles than nodes it must be; the blend keeps every row sum, hence all momenta.
  double blend() const { return blend_; }
  const Vector& lumped() const { return lumped_; }
  /// The diagonal, one entry a node: m_i or M_ii.
  const Vector& diagonal() const { return consistent_ ? memory_.diagonal : lumped_; }
  /// out = M v, D components a node.
  void multiply(const Vector& v, Vector& out) const;
  /// M v = b by conjugate gradients scaled by the diagonal, from v = v0. M may be nearly singular (slivers at the
  /// body's edge); b = sum m_p v_p N_i lies in its range, so the iteration converges, and what M does not see keeps the
  /// start v0. Returns the iterations; `residual` is relative, scaled.
  int solve(const Vector& b, Vector& v, double& residual) const;
  /// As Energy::far_pairs.
  void far_pairs(const std::function<void(std::int32_t, std::int32_t)>& add) const {
    if (consistent_) memory_.ghost.pairs(add);
  }
  /// H += factor M.
  void assemble(double factor, BlockMatrix<D>& H) const;
  double dot(const Vector& a, const Vector& b) const;

 private:
  void compute_diagonal();

  const Plan<D>& plan_;
  const Particles<D>& particles_;
  const Vector& lumped_;
  bool consistent_;
  double blend_ = 0;
  Parallel& parallel_;
  Work& work_;
  MassMemory<D> own_;
  MassMemory<D>& memory_;
};

extern template class MassMatrix<2>;
extern template class MassMatrix<3>;

}  // namespace pf
