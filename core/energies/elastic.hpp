// The elastic energy of the particles: sum_p V_p^0 psi(F_p(x^)), F_p = (I + sum_j u_j (x) grad N_j) F_p^n (THEORY T3,
// T4).
#pragma once

#include <memory>
#include <span>

#include "core/energies/energy.hpp"
#include "core/grid/particles.hpp"
#include "core/grid/plan.hpp"
#include "core/materials/law.hpp"
#include "core/step_report.hpp"

namespace pf {

template <int D>
using Laws = std::vector<std::unique_ptr<Law<D>>>;  ///< one a material

template <int D>
class ElasticEnergy final : public Energy<D> {
 public:
  /// All are referred to, none is copied; they outlive this.
  ElasticEnergy(const Plan<D>& plan, const Particles<D>& particles, const Laws<D>& laws, Parallel& parallel, Work& work)
      : plan_(plan), particles_(particles), laws_(laws), parallel_(parallel), work_(work) {}

  double value(const Vector& u) override;
  double gradient(const Vector& u, Vector& g, Vector& magnitude) override;
  void prepare_hessian(const Vector& u, bool project) override;
  void hessian_product(const Vector& p, Vector& Hp) override;
  void diagonal(std::vector<Mat<D>>& blocks) override;
  void assemble(BlockMatrix<D>& H) override;
  bool assemble_stencil(StencilMatrix<D>& H, const std::vector<std::int32_t>& row_of) override;

  /// g += dE/du at u = 0, where F_p = F_p^n: nothing is gathered. What an explicit step needs.
  void add_force_at_rest(Vector& g);
  /// F_p(x^) of the newest evaluation.
  const std::vector<Mat<D>>& F() const { return F_; }

 private:
  static constexpr int W = lane_count<D>;
  static constexpr int components = tangent_components<D>;

  void deform(const Block<D>& block, const Vector& u);
  double block_energy(const Block<D>& block);
  /// psi and P of a block's particles.
  void block_stress(const Block<D>& block, const std::vector<Mat<D>>& F);
  /// V_p^0 P_p F_p^nT, a lane a particle.
  void batch_flux(const Batch& batch, Wide<W> (*flux)[D]) const;
  void block_tangents(const Block<D>& block, bool project);
  double ordered_sum() const;

  const Plan<D>& plan_;
  const Particles<D>& particles_;
  const Laws<D>& laws_;
  Parallel& parallel_;
  Work& work_;
  std::vector<Mat<D>> F_, P_;
  std::vector<double> psi_;
  std::vector<double> block_sum_;
  std::vector<Narrow<W>> tangent_;  ///< V_p^0 times the tangent with respect to F^, `components` a batch
};

extern template class ElasticEnergy<2>;
extern template class ElasticEnergy<3>;

}  // namespace pf
