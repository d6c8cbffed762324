// Signed distances of a scene's rigid solids and regions over a 2D view.
#pragma once

#include <vector>

#include "core/snapshot.hpp"
#include "render/camera.hpp"

namespace pf {

/// Distances in pixels, sampled every `pitch` pixels from the lower left corner of the view; three values a
/// sample (solids, constraints, loads), rows from the bottom, the least over all members. Far from a surface
/// values are interpolated from a coarser raster: `distance` is called about once a sample near surfaces and
/// once in 64 elsewhere.
struct DistanceMap {
  int columns = 0, rows = 0;
  double pitch = 2;  ///< [px]
  std::vector<float> values;
  bool solids = false, regions = false;  ///< whether anything of the kind is in the scene

  static DistanceMap sample(const Snapshot& snapshot, const Camera2D& camera, ViewSize size, double pitch = 2);
};

}  // namespace pf
