// APIC (Jiang et al. 2015; THEORY T5): particles carry an affine velocity, so that a lumped transfer keeps angular
// momentum.
#pragma once

#include "core/transfers/transfer.hpp"

namespace pf {

template <int D>
class ApicTransfer final : public Transfer<D> {
 public:
  bool affine() const override { return true; }
  StateCheck grid_to_particles(const Plan<D>& plan, const GridState<D>& grid, const Particles<D>& particles,
                               Parallel& parallel, const Motion<D>& to) const override;
  void carry(const Plan<D>& plan, const Particles<D>& particles, const Vector& v, Parallel& parallel,
             Vector& momentum) const override;
  double stiffening(double s) const override { return 2 / (1 + s); }
};

}  // namespace pf
