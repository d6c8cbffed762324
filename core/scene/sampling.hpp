// Bodies -> particles (INTERFACE fine print 5).
#pragma once

#include <vector>

#include "core/scene/solid.hpp"

namespace pf {

struct Samples {
  std::vector<Vec3> X;         ///< reference positions; z = 0 in 2D
  std::vector<double> volume;  ///< V_p^0 of each [m^d]; sum = the shape's measure, uniform unless fitted
  /// Edges of the parallelepiped that each stands for [m], as columns (core/grid/domain.hpp); empty: cubes.
  std::vector<Mat3> domain;
};

/// Throws InputError naming /bodies/`index` when no point lies in the shape.
Samples sample_body(const Scene& scene, std::size_t index);
/// An upper estimate of how many particles sample_body would give, from bounds and measure, without making
/// them: to refuse a scene before it is built.
double estimated_particles(const Scene& scene, std::size_t index);

}  // namespace pf
