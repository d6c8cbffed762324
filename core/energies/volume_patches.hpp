// F-bar: particles of one cell and one material share their change of volume in a step, so that a nearly incompressible
// body asks one thing a cell of its nodes and not one a particle (locking). With F^ the grid's own deformation and
// J^ = det F^,
//
//     J~ = sum V_p^n J^_p / sum V_p^n,   F-bar_p = (J~ / J^_p)^(1/D) F^_p F_p^n,   E = sum_p V_p^0 psi(F-bar_p)
//
// over the particles of a patch, V_p^n = V_p^0 det F_p^n (de Souza Neto, Peric, Dutko and Owen 1996; for the material
// point method Coombs, Charlton, Cortis and Augarde 2018, who take the forces of F-bar as they are: here they are
// derivatives of E, so that Newton's matrix is symmetric). F-bar is what a particle keeps, so stresses and energies of
// what is stored are those of the step, and no history is needed beside it.
#pragma once

#include <utility>

#include "core/energies/elastic.hpp"

namespace pf {

/// Two particles or more, consecutive in the plan's order.
struct VolumePatch {
  std::int32_t begin, end;              ///< particles
  std::int32_t batch_begin, batch_end;  ///< of their cell
  std::int16_t node;                    ///< the cell's first node in the block's own lattice
};

/// body(patch) for the patches of a block, in order. A particle by itself is no patch: its F-bar is its F.
template <int D, class Body>
void for_each_patch(const Plan<D>& plan, const Particles<D>& particles, const Laws<D>& laws, const Block<D>& block,
                    Body&& body) {
  const auto batch = [&](std::int32_t i) -> const Batch& { return plan.batches()[static_cast<std::size_t>(i)]; };
  const auto material = [&](std::int32_t p) { return particles.material[static_cast<std::size_t>(p)]; };
  for (std::int32_t i = block.batch_begin, last = i; i < block.batch_end; i = last) {
    while (last < block.batch_end && batch(last).node == batch(i).node) ++last;
    const std::int32_t end = batch(last - 1).first + batch(last - 1).count;
    for (std::int32_t p = batch(i).first, q = p; p < end; p = q) {
      while (q < end && material(q) == material(p)) ++q;
      if (q - p > 1 && laws[material(p)]->shares_volume()) body(VolumePatch{p, q, i, last, batch(i).node});
    }
  }
}

/// Of a patch with volumes V^n and changes J^, particle by particle: share[p] becomes its part of the new volume,
/// stretch[p] = (J~ / J^_p)^(1/D). False where a J^ is not positive: E is infinite there.
template <int D>
bool share_volume(std::span<const double> volume, std::span<const double> J, double* share, double* stretch);

/// After a step: F_p becomes F-bar_p in `to.F`. The least and the largest J of all particles then.
template <int D>
std::pair<double, double> share_volumes(const Plan<D>& plan, const Particles<D>& particles, const Laws<D>& laws,
                                        Parallel& parallel, const Motion<D>& to);
extern template bool share_volume<2>(std::span<const double>, std::span<const double>, double*, double*);
extern template bool share_volume<3>(std::span<const double>, std::span<const double>, double*, double*);
extern template std::pair<double, double> share_volumes<2>(const Plan<2>&, const Particles<2>&, const Laws<2>&,
                                                           Parallel&, const Motion<2>&);
extern template std::pair<double, double> share_volumes<3>(const Plan<3>&, const Particles<3>&, const Laws<3>&,
                                                           Parallel&, const Motion<3>&);

}  // namespace pf
