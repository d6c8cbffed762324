// PIC, FLIP and their blend (THEORY T5): v_p = sum_j v_j^{n+1} N_j + a (v_p^n - sum_j v_j^n N_j), a = flip ratio.
// PIC (a = 0) filters the velocity at every step and loses angular momentum; FLIP (a = 1) keeps what the grid cannot
// see, noise included.
#pragma once

#include "core/transfers/transfer.hpp"

namespace pf {

template <int D>
class FlipTransfer final : public Transfer<D> {
 public:
  explicit FlipTransfer(double flip_ratio) : flip_ratio_(flip_ratio) {}
  bool affine() const override { return false; }
  StateCheck grid_to_particles(const Plan<D>& plan, const GridState<D>& grid, const Particles<D>& particles,
                               Parallel& parallel, const Motion<D>& to) const override;
  void carry(const Plan<D>& plan, const Particles<D>& particles, const Vector& v, Parallel& parallel,
             Vector& momentum) const override;
  double stiffening(double s) const override {
    return 2 * (1 + flip_ratio_ * (1 - s)) / (1 + s + flip_ratio_ * (1 - s));
  }

 private:
  double flip_ratio_;
};

}  // namespace pf
