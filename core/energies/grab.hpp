// The mouse's spring: k/2 |x_g(u) - target|^2, x_g = sum_p w_p x_p(u) the mean of the held particles. It acts inside
// the implicit solve, so that a stiff pull is as stable as the material.
#pragma once

#include "core/energies/energy.hpp"
#include "core/grid/plan.hpp"

namespace pf {

/// The particles that the mouse holds, by id, with weights that add up to 1.
struct Held {
  std::vector<std::uint32_t> id;
  std::vector<double> weight;
};

template <int D>
class GrabSpring final : public Energy<D> {
 public:
  /// `stiffness` [N/m]; `target` [m]. Held particles are looked up in `particles` by id.
  GrabSpring(const Plan<D>& plan, const Particles<D>& particles, const Held& held, const Vec<D>& target,
             double stiffness);

  double value(const Vector& u) override;
  double gradient(const Vector& u, Vector& g, Vector& magnitude) override;
  void prepare_hessian(const Vector&, const Projected&) override {}
  void hessian_product(const Vector& p, Vector& Hp) override;
  void diagonal(std::vector<Mat<D>>& blocks) override;
  /// The spring couples all held nodes; only the couplings in H's pattern are kept (a preconditioner's choice), the
  /// direct solver therefore is not used while the mouse holds on.
  void assemble(BlockMatrix<D>& H) override;

  Vec<D> held_position(const Vector& u) const;
  /// Force on the material [N].
  Vec<D> force(const Vector& u) const { return stiffness_ * (target_ - held_position(u)); }

 private:
  std::vector<std::pair<std::int32_t, double>> nodes_;  ///< a = sum_p w_p N_i(x_p): d x_g / d u_i = a I
  Vec<D> start_ = Vec<D>::Zero();                       ///< x_g at u = 0
  Vec<D> target_;
  double stiffness_;
};

extern template class GrabSpring<2>;
extern template class GrabSpring<3>;

}  // namespace pf
