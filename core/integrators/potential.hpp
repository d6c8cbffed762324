// The incremental potential of a stage (THEORY T4): a sum of energies over the nodes of one plan.
#pragma once

#include "core/energies/energy.hpp"
#include "core/grid/plan.hpp"
#include "core/solvers/feasible_set.hpp"
#include "core/solvers/objective.hpp"

namespace pf {

template <int D>
class IncrementalPotential final : public Objective<D> {
 public:
  /// `terms` are referred to. `reference_forces`: the vectors whose norms T4 compares with, beside the elastic sizes.
  IncrementalPotential(const Plan<D>& plan, const Vector& lumped_mass, const FeasibleSet<D>& set,
                       std::vector<Energy<D>*> terms, const std::vector<const Vector*>& reference_forces);

  double value(const Vector& u) override;
  double gradient(const Vector& u, Vector& g) override;
  void prepare_hessian(const Vector& u, bool project) override;
  void hessian_product(const Vector& p, Vector& Hp) override;
  void diagonal(std::vector<Mat<D>>& blocks) override;
  void assemble(BlockMatrix<D>& H) override;
  Lattice<D> lattice() const override { return {plan_.node_indices(), plan_.nodes_per_axis() - 1}; }
  void assemble_stencil(StencilMatrix<D>& H, const std::vector<std::int32_t>& row_of) override;
  double norm(const Vector& g) const override;
  double scale() const override;
  double energy_scale() const override { return energy_scale_; }

 private:
  void make_pattern(BlockMatrix<D>& H) const;

  const Plan<D>& plan_;
  const FeasibleSet<D>& set_;
  std::vector<Energy<D>*> terms_;
  Vector weight_;            ///< 1 / m_i, a component
  double reference_ = 0;     ///< the largest norm of the reference forces
  Vector magnitude_;         ///< s_i of the newest gradient
  std::vector<char> fixed_;  ///< nodes without any free direction
  double energy_scale_ = 0;
  bool have_pattern_ = false;
};

extern template class IncrementalPotential<2>;
extern template class IncrementalPotential<3>;

}  // namespace pf
