// The cells of a particle lattice that a solid may reach.
#pragma once

#include "core/scene/sampling_lattice.hpp"

namespace pf {

/// Calls visit(k) for every lattice cell that may hold a point of the solid: blocks of cells that are out of reach
/// are passed over whole, so that a thin shape across large bounds costs what its surface does.
template <class Visit>
void visit_cells(const Solid& solid, const ParticleLattice& lattice, const ParticleLattice::Index& first,
                 const ParticleLattice::Index& last, const Visit& visit) {
  std::array<std::int64_t, 3> count{1, 1, 1};
  int longest = 0;
  Vec3 extent = Vec3::Zero(), middle = Vec3::Zero();
  for (int a = 0; a < lattice.dimension(); ++a) {
    count[a] = last[a] - first[a] + 1;
    if (count[a] <= 0) return;
    if (count[a] > count[longest]) longest = a;
    extent[a] = static_cast<double>(count[a]) * lattice.spacing();
    middle[a] = static_cast<double>(first[a]) + 0.5 * static_cast<double>(count[a]);
  }
  if (solid.distance_is_bound() && solid.distance(lattice.at(middle)) > 0.5 * extent.norm() + lattice.tolerance())
    return;
  if (count[longest] <= 4) {
    ParticleLattice::Index k{};
    for (k[2] = first[2]; k[2] <= last[2]; ++k[2])
      for (k[1] = first[1]; k[1] <= last[1]; ++k[1])
        for (k[0] = first[0]; k[0] <= last[0]; ++k[0]) visit(k);
    return;
  }
  ParticleLattice::Index low = last, high = first;
  low[longest] = first[longest] + count[longest] / 2 - 1;
  high[longest] = low[longest] + 1;
  visit_cells(solid, lattice, first, low, visit);
  visit_cells(solid, lattice, high, last, visit);
}

}  // namespace pf
