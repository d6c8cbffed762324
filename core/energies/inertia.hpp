// Inertia: (u - dt v^n)^T M (u - dt v^n) / (2 dt^2) (THEORY T4), with the lumped or the consistent mass matrix.
#pragma once

#include "core/energies/energy.hpp"
#include "core/grid/mass.hpp"

namespace pf {

template <int D>
class Inertia final : public Energy<D> {
 public:
  /// `v`: node velocities v^n; `mass` is referred to.
  Inertia(const MassMatrix<D>& mass, const Vector& v, double dt)
      : mass_(mass), u_free_(dt * v), scale_(1 / (dt * dt)) {}

  double value(const Vector& u) override;
  double gradient(const Vector& u, Vector& g, Vector& magnitude) override;
  void prepare_hessian(const Vector&, bool) override {}
  void hessian_product(const Vector& p, Vector& Hp) override;
  void diagonal(std::vector<Mat<D>>& blocks) override;
  void assemble(BlockMatrix<D>& H) override;
  /// M (x~ - x)/dt^2: what Newton's tolerance is measured against [N].
  Vector free_flight_force() const;

 private:
  const MassMatrix<D>& mass_;
  Vector u_free_;  ///< x~ - x
  double scale_;
  Vector difference_, product_;
};

extern template class Inertia<2>;
extern template class Inertia<3>;

}  // namespace pf
