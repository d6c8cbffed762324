// FMPM(k) (Nairn and Hammerquist 2021): PIC from grid velocities that k terms of the series for M^-1 have sharpened
// (sharpen_velocity). 1 is PIC; infinity the consistent velocity transfer.
#pragma once

#include <cmath>

#include "core/transfers/flip.hpp"

namespace pf {

template <int D>
class FmpmTransfer final : public Transfer<D> {
 public:
  explicit FmpmTransfer(int order) : order_(order) {}
  bool affine() const override { return false; }
  int order() const override { return order_; }
  StateCheck grid_to_particles(const Plan<D>& plan, const GridState<D>& grid, const Particles<D>& particles,
                               Parallel& parallel, const Motion<D>& to) const override {
    return FlipTransfer<D>(0).grid_to_particles(plan, grid, particles, parallel, to);
  }
  void carry(const Plan<D>& plan, const Particles<D>& particles, const Vector& v, Parallel& parallel,
             Vector& momentum) const override {
    FlipTransfer<D>(0).carry(plan, particles, v, parallel, momentum);
  }
  double stiffening(double s) const override { return 2 / (2 - std::pow(1 - s, order_)); }

 private:
  int order_;
};

}  // namespace pf
