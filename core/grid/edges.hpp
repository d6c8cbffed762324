// Splines that end at a wall (`boundary_correction`). A spline that runs on through a wall has no coefficient that is
// the motion at the wall: holding the nodes in and behind it holds too much, an error of first order. Where a plane of
// nodes is the wall, the function behind it is given away to the two before it (Steffen, Wallstedt, Guilkey, Kirby and
// Berzins 2008): the node on the plane then has the motion at the wall.
#pragma once

#include <array>
#include <optional>

#include "core/bases/basis.hpp"

namespace pf {

/// Lattice planes that all material lies above (low) or below (high), of one axis.
struct EdgePlanes {
  std::optional<long long> low, high;
  bool any() const { return low || high; }
  bool operator==(const EdgePlanes&) const = default;
};

/// N_p += 2 N_{p-1}, N_{p+1} -= N_{p-1}, N_{p-1} = 0 at a low plane p, mirrored at a high one: as if the coefficient
/// behind the wall were 2 u_p - u_{p+1}. Linear fields stay exact, the sum stays 1, no function is negative before the
/// wall; the motion bends there no more (quadratic: it is linear in the last half cell). `weights[r * stride]` is of
/// node first + r. Needs particles no more than half a cell behind the plane.
template <class T>
void end_at_walls(int nodes_per_axis, const EdgePlanes& planes, long long first, int stride, T* weights) {
  const auto change = [&](long long plane, int inward) {
    const auto at = [&](long long node) -> T* {
      return node >= first && node < first + nodes_per_axis ? weights + (node - first) * stride : nullptr;
    };
    T *const behind = at(plane - inward), *const on = at(plane), *const before = at(plane + inward);
    if (!behind || !on || !before) return;
    *on += 2 * *behind;
    *before -= *behind;
    *behind = T{};
  };
  if (planes.low) change(*planes.low, 1);
  if (planes.high) change(*planes.high, -1);
}

}  // namespace pf
