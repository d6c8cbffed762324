// Which planes of nodes are walls: where `boundary_correction` ends splines (core/grid/edges.hpp).
#pragma once

#include <array>

#include "core/grid/edges.hpp"
#include "core/grid/particles.hpp"
#include "core/scene/scene.hpp"

namespace pf {

/// Faces of boundaries that do not move and of constraints, of boxes and half spaces along the axes, that lie on planes
/// of nodes with every particle's reference position on one side; of several the nearest. None unless
/// grid.boundary_correction is set.
template <int D>
std::array<EdgePlanes, D> edge_planes(const Scene& scene, const Particles<D>& particles);

extern template std::array<EdgePlanes, 2> edge_planes<2>(const Scene&, const Particles<2>&);
extern template std::array<EdgePlanes, 3> edge_planes<3>(const Scene&, const Particles<3>&);

}  // namespace pf
