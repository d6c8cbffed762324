// Particles that follow a body's surface.
#pragma once

#include "core/scene/sampling.hpp"
#include "core/scene/sampling_lattice.hpp"

namespace pf {

/// A particle for each lattice cell that the solid fills, wholly or in part: at the centroid of the part within, as
/// large as that (to 1e-3 of a cell or better), and with the domain that has its second moments, so that quadratic
/// functions are integrated over the body exactly. A part below a quarter of a cell goes to the fullest of the cells
/// beside it, unless none of these is fuller than that. Whole cells give the lattice's own points.
Samples fitted_points(const Solid& solid, const ParticleLattice& lattice);

}  // namespace pf
