// The elastic energy of the particles: sum_p V_p^0 psi(F_p(x^)), F_p = (I + sum_j u_j (x) grad N_j) F_p^n (THEORY T3,
// T4).
#pragma once

#include <algorithm>
#include <memory>
#include <span>

#include "core/energies/energy.hpp"
#include "core/grid/particles.hpp"
#include "core/grid/plan.hpp"
#include "core/materials/law.hpp"
#include "core/math/scratch.hpp"
#include "core/step_report.hpp"

namespace pf {

template <int D>
using Laws = std::vector<std::unique_ptr<Law<D>>>;  ///< one a material

/// Whether any of these materials shares volume changes.
template <int D>
bool any_shares_volume(const Laws<D>& laws) {
  return std::any_of(laws.begin(), laws.end(), [](const auto& law) { return law->shares_volume(); });
}

template <int D>
struct ElasticChunk;
template <int D>
struct BarredBlock;
struct VolumePatch;

/// What an ElasticEnergy computes with; kept between steps for its memory alone.
struct ElasticMemory {
  Scratch tangents;
  std::vector<double> block_sum;
  // Of particles as they are, by find_rest().
  Vector rest_force;
  double rest_energy = 0;
  std::int64_t rest_plan = -1;  ///< Plan::made() that they belong to
  // How particles of a cell are coupled where they share volume changes (core/energies/elastic_patches.hpp).
  std::vector<std::int32_t> patch_start;  ///< of each block, and how many there are
  std::vector<std::int16_t> patch_node;   ///< the cell's first node in the block's own lattice
  std::vector<double> patch_coupling;
};

template <int D>
class ElasticEnergy final : public Energy<D> {
 public:
  /// All are referred to, none is copied; they outlive this. `memory`, where it is given, outlives this too.
  ElasticEnergy(const Plan<D>& plan, const Particles<D>& particles, const Laws<D>& laws, Parallel& parallel, Work& work,
                ElasticMemory* memory = nullptr)
      : plan_(plan),
        particles_(particles),
        laws_(laws),
        parallel_(parallel),
        work_(work),
        memory_(memory ? *memory : own_) {}

  double value(const Vector& u) override;
  double gradient(const Vector& u, Vector& g, Vector& magnitude) override;
  void prepare_hessian(const Vector& u, const Projected& project) override;
  void hessian_product(const Vector& p, Vector& Hp) override;
  void diagonal(std::vector<Mat<D>>& blocks) override;
  /// Stresses are as exact as F: a few units in the last place of 1, times the stiffness.
  double rounding(Vector& level) override;
  void assemble(BlockMatrix<D>& H) override;
  bool assemble_stencil(StencilMatrix<D>& H, const std::vector<std::int32_t>& row_of) override;

  /// g += dE/du at u = 0, where F_p = F_p^n: nothing is gathered. What an explicit step needs. As found before, if it
  /// was.
  void add_force_at_rest(Vector& g);
  /// Keeps that force for the next add_force_at_rest: what an explicit step's report needs, the energy, and what the
  /// next one begins with come of the same stresses. Returns E at u = 0.
  double find_rest();
  /// F_p(x^), a particle each; F-bar where volume changes are shared.
  std::vector<Mat<D>> deformed(const Vector& u) const;

 private:
  static constexpr int W = lane_count<D>;
  static constexpr int components = tangent_components<D>;

  /// Of a block's nodes, for the most that a basis has.
  static constexpr int most_edge = block_edge + max_nodes_per_axis - 1;
  static constexpr int most_block_nodes = D == 2 ? most_edge * most_edge : most_edge * most_edge * most_edge;
  using Chunk = ElasticChunk<D>;

  /// body(chunk) for the block's particles at u, chunk.F filled in.
  template <class Body>
  void for_each_deformed(const Block<D>& block, const Vector& u, Body&& body) const;
  /// chunk.F from the block's own displacements.
  void deform(const double* local, Chunk& chunk) const;
  double chunk_energy(const Chunk& chunk) const;
  /// chunk.psi and chunk.P at F, which starts with the chunk's first particle.
  void chunk_stress(const Block<D>& block, const Mat<D>* F, Chunk& chunk) const;
  /// V_p^0 P_p F_p^nT, a lane a particle.
  void batch_flux(const Batch& batch, const Mat<D>* stress, Wide<W> (*flux)[D]) const;
  void chunk_tangents(const Block<D>& block, const Chunk& chunk, const Projected& project);
  double ordered_sum() const;
  double sum_force_at_rest(Vector& g);

  // The same where materials share volume changes (elastic_barred.cpp, elastic_patches.cpp); `u` null: at rest.
  bool barred() const { return any_shares_volume(laws_); }
  double barred_value(const Vector& u);
  double barred_gradient(const Vector* u, Vector& g, Vector* magnitude);
  void barred_tangents(const Vector& u, const Projected& project);
  void deform_block(const Block<D>& block, const Vector* u, BarredBlock<D>& state) const;
  void block_stress(const Block<D>& block, BarredBlock<D>& state) const;
  void block_flux(const Block<D>& block, BarredBlock<D>& state) const;
  void block_tangents(const Block<D>& block, int b, bool project, BarredBlock<D>& state);
  void single_tangents(const Block<D>& block, bool project, const BarredBlock<D>& state,
                       const std::vector<float*>& place) const;
  double patch_tangents(const Block<D>& block, const VolumePatch& patch, bool project, const BarredBlock<D>& state,
                        const std::vector<float*>& place, std::vector<Mat<D>>& of_L,
                        std::vector<Mat<D>>& of_volume) const;
  template <int K>
  void couple(int b, const double* p, double* Hp) const;
  template <int K>
  void couple_diagonal(int b, double* upper) const;
  template <int K>
  void couple_blocks(const Block<D>& block, int b, BlockMatrix<D>& H) const;
  template <int K>
  void couple_stencil(const Block<D>& block, int b, const std::vector<std::int32_t>& row_of, StencilMatrix<D>& H) const;

  const Plan<D>& plan_;
  const Particles<D>& particles_;
  const Laws<D>& laws_;
  Parallel& parallel_;
  Work& work_;
  ElasticMemory own_;
  ElasticMemory& memory_;
  Narrow<W>* tangent_ = nullptr;  ///< V_p^0 times the tangent with respect to F^, `components` a batch
};

extern template class ElasticEnergy<2>;
extern template class ElasticEnergy<3>;

}  // namespace pf
