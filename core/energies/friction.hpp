// Coulomb friction of an inner minimisation (THEORY T7): b |t|, t the tangential slip of a node against its wall, b =
// mu f_n frozen. The corner at t = 0 belongs to FeasibleSet (a node at rest sticks); this is the smooth part away from
// it.
#pragma once

#include "core/energies/energy.hpp"
#include "core/solvers/feasible_set.hpp"

namespace pf {

template <int D>
class Friction final : public Energy<D> {
 public:
  /// `set` is referred to: its rub_bound may change between minimisations.
  explicit Friction(const FeasibleSet<D>& set) : set_(set) {}

  double value(const Vector& u) override;
  double gradient(const Vector& u, Vector& g, Vector& magnitude) override;
  void prepare_hessian(const Vector& u, const Projected& project) override;
  void hessian_product(const Vector& p, Vector& Hp) override;
  void diagonal(std::vector<Mat<D>>& blocks) override;
  void assemble(BlockMatrix<D>& H) override;

 private:
  const FeasibleSet<D>& set_;
  std::vector<std::pair<std::int32_t, Mat<D>>> block_;  ///< of the nodes that slip
};

extern template class Friction<2>;
extern template class Friction<3>;

}  // namespace pf
