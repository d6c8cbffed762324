// Coulomb friction of an inner minimisation (THEORY T7): mu f_n h(|t|), t the tangential slip u - wall of a node, f_n frozen.
// h(s) = sqrt(s^2 + eps^2) - eps rounds the corner at rest over a slip of eps, far below anything visible.
#pragma once

#include "core/energies/energy.hpp"

namespace pf {

/// A node that rubs.
template <int D>
struct FrictionContact {
  std::int32_t node = 0;
  Vec<D> normal = Vec<D>::Zero();
  Vec<D> wall = Vec<D>::Zero();  ///< displacement of the wall during the step [m]
  double coefficient = 0;        ///< mu
  double normal_force = 0;       ///< f_n >= 0 [N]
};

template <int D>
class Friction final : public Energy<D> {
 public:
  /// `contacts` are referred to; `slip` = eps [m].
  Friction(const std::vector<FrictionContact<D>>& contacts, double slip) : contacts_(contacts), slip_(slip) {}

  double value(const Vector& u) override;
  double gradient(const Vector& u, Vector& g, Vector& magnitude) override;
  void prepare_hessian(const Vector& u, bool project) override;
  void hessian_product(const Vector& p, Vector& Hp) override;
  void diagonal(std::vector<Mat<D>>& blocks) override;
  void assemble(BlockMatrix<D>& H) override;

 private:
  Vec<D> slip_of(const FrictionContact<D>& c, const Vector& u) const;

  const std::vector<FrictionContact<D>>& contacts_;
  double slip_;
  std::vector<Mat<D>> block_;
};

extern template class Friction<2>;
extern template class Friction<3>;

}  // namespace pf
