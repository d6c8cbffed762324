// Inertia: (u - dt v^n)^T M (u - dt v^n) / (2 dt^2) (THEORY T4), with the lumped or the consistent mass matrix; of
// other time schemes scale/2 (u - u_free)^T M (u - u_free).
#pragma once

#include "core/energies/energy.hpp"
#include "core/grid/mass.hpp"

namespace pf {

/// What an Inertia computes with; kept between steps for its memory alone.
struct InertiaVectors {
  Vector u_free, difference, product;
};

template <int D>
class Inertia final : public Energy<D> {
 public:
  /// `v`: node velocities v^n; `mass` is referred to, and `vectors` where it is given.
  Inertia(const MassMatrix<D>& mass, const Vector& v, double dt, InertiaVectors* vectors = nullptr)
      : mass_(mass), scale_(1 / (dt * dt)), vectors_(vectors ? *vectors : own_) {
    vectors_.u_free = dt * v;
  }
  /// `scale` in 1/s^2; `u_free`: where the nodes go without forces.
  Inertia(const MassMatrix<D>& mass, double scale, const Vector& u_free, InertiaVectors* vectors = nullptr)
      : mass_(mass), scale_(scale), vectors_(vectors ? *vectors : own_) {
    vectors_.u_free = u_free;
  }
  Inertia(const Inertia&) = delete;

  double value(const Vector& u) override;
  double gradient(const Vector& u, Vector& g, Vector& magnitude) override;
  void prepare_hessian(const Vector&, const Projected&) override {}
  void hessian_product(const Vector& p, Vector& Hp) override;
  void diagonal(std::vector<Mat<D>>& blocks) override;
  void far_pairs(const std::function<void(std::int32_t, std::int32_t)>& add) const override { mass_.far_pairs(add); }
  void assemble(BlockMatrix<D>& H) override;
  /// scale M (x~ - x): what Newton's tolerance is measured against [N].
  void free_flight_force(Vector& f) const;

 private:
  const MassMatrix<D>& mass_;
  double scale_;
  InertiaVectors own_;
  InertiaVectors& vectors_;  ///< u_free: x~ - x
};

extern template class Inertia<2>;
extern template class Inertia<3>;

}  // namespace pf
