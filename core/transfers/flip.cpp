#include "core/transfers/flip.hpp"

namespace pf {

template <int D>
void FlipTransfer<D>::grid_to_particles(const Plan<D>& plan, const GridState<D>& grid, Particles<D>& particles,
                                        Parallel& parallel) const {
  // One gather: what the grid adds is sum_j (v_j^{n+1} - a v_j^n) N_j.
  std::vector<Vec<D>> gained(particles.size());
  if (flip_ratio_ == 0)
    gather_field<D>(plan, grid.v_end, parallel, gained);
  else
    gather_field<D>(plan, grid.v_end - flip_ratio_ * grid.v, parallel, gained);
  for (std::size_t p = 0; p < particles.size(); ++p) particles.v[p] = flip_ratio_ * particles.v[p] + gained[p];
}

template class FlipTransfer<2>;
template class FlipTransfer<3>;

}  // namespace pf
