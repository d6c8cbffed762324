// The incremental potential of a stage (THEORY T4): a sum of energies over the nodes of one plan.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "core/energies/energy.hpp"
#include "core/grid/plan.hpp"
#include "core/solvers/feasible_set.hpp"
#include "core/solvers/objective.hpp"

namespace pf {

/// What an IncrementalPotential computes with; kept between steps for its memory alone.
template <int D>
struct PotentialVectors {
  Vector weight;            ///< 1 / m_i, a component
  Vector magnitude;         ///< s_i of the newest gradient
  Vector rounding;          ///< of Energy::rounding
  std::vector<char> fixed;  ///< nodes without any free direction
  Vector over_free;
  std::vector<Mat<D>> free;
};

template <int D>
class IncrementalPotential final : public Objective<D> {
 public:
  /// `terms` are referred to, and `vectors` where it is given. `reference_forces`: the vectors whose norms T4 compares
  /// with, beside the elastic sizes.
  IncrementalPotential(const Plan<D>& plan, const Vector& lumped_mass, const FeasibleSet<D>& set,
                       const std::vector<Energy<D>*>& terms, std::span<const Vector* const> reference_forces,
                       PotentialVectors<D>* vectors = nullptr);
  IncrementalPotential(const IncrementalPotential&) = delete;

  double value(const Vector& u) override;
  double gradient(const Vector& u, Vector& g) override;
  void prepare_hessian(const Vector& u, const Projected& project) override;
  void hessian_product(const Vector& p, Vector& Hp) override;
  void diagonal(std::vector<Mat<D>>& blocks) override;
  void assemble(BlockMatrix<D>& H) override;
  Lattice<D> lattice() const override { return {plan_.node_indices(), plan_.nodes_per_axis() - 1}; }
  void assemble_stencil(StencilMatrix<D>& H, const std::vector<std::int32_t>& row_of) override;
  double norm(const Vector& g) const override;
  double scale() const override;
  double rounding() override;
  double energy_scale() const override { return energy_scale_ + std::sqrt(2 * stiffness_ * energy_scale_); }

 private:
  void make_pattern(BlockMatrix<D>& H) const;

  const Plan<D>& plan_;
  const FeasibleSet<D>& set_;
  double norm_of_sizes(const Vector& sizes) const;
  std::span<Energy<D>* const> terms() const { return {terms_.data(), term_count_}; }

  std::array<Energy<D>*, 8> terms_{};
  std::size_t term_count_ = 0;
  double reference_ = 0;  ///< the largest norm of the reference forces
  PotentialVectors<D> own_;
  PotentialVectors<D>& vectors_;
  double energy_scale_ = 0;
  double rounding_ = -1, stiffness_ = 0;  ///< once they have been asked for; stiffness_: K of Energy::rounding [J]
  bool have_pattern_ = false;
};

extern template class IncrementalPotential<2>;
extern template class IncrementalPotential<3>;

}  // namespace pf
