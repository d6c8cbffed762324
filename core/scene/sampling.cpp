#include "core/scene/sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "core/scene/sampling_fitted.hpp"
#include "core/scene/sampling_lattice.hpp"
#include "core/scene/scene_io.hpp"

namespace pf {
namespace {

[[noreturn]] void refuse(std::size_t index, const std::string& found, const std::string& allowed) {
  throw InputError("", {{"/bodies/" + std::to_string(index) + "/shape", found, allowed}});
}

std::string number(double v) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.4g", v);
  return text.data();
}

/// Positions by the body's sampling; sorted by lattice index, so that their order says nothing of how they were found.
std::vector<Vec3> positions(const Body& body, const Solid& solid, const ParticleLattice& lattice) {
  if (body.sampling == "jittered") return jittered_points(solid, lattice, body.seed);
  if (body.sampling == "poisson_disc") return poisson_disc_points(solid, lattice, body.seed);
  return lattice_points(solid, lattice);
}

}  // namespace

Samples sample_body(const Scene& scene, std::size_t index) {
  const Body& body = scene.bodies[index];
  const auto solid = make_solid(body.shape, scene.dimension, scene.constants);
  const Bounds bounds = solid->bounds();
  if (!bounds.min.allFinite() || !bounds.max.allFinite())
    refuse(index, "a shape without end", "a bounded shape, for instance the intersection with a box");
  const ParticleLattice lattice(scene.grid.spacing, body.particles_per_axis, scene.dimension, bounds);
  const std::string spacing = number(lattice.spacing()) + " m apart";
  if (!lattice.representable())
    refuse(index, "a shape too far from the origin for particles " + spacing,
           "coordinates below 1e15 particle spacings");
  const bool fitted = body.sampling == "fitted";
  Samples samples = fitted ? fitted_points(*solid, lattice) : Samples{positions(body, *solid, lattice), {}, {}};
  if (samples.X.empty())
    refuse(index, "no particle lies in the shape",
           "a shape that holds some of the points " + spacing + "; a finer grid or more particles_per_axis");
  const double measure = solid->measure(lattice.spacing());
  const double mean = measure / static_cast<double>(samples.X.size());
  if (!(mean > 1e-9 * lattice.cell_measure()))
    refuse(index, "a shape with measure " + number(measure), scene.dimension == 2 ? "an area > 0" : "a volume > 0");
  if (!fitted) {
    samples.volume.assign(samples.X.size(), mean);
    return samples;
  }
  const double sum = std::accumulate(samples.volume.begin(), samples.volume.end(), 0.0);
  for (double& V : samples.volume) V *= measure / sum;
  return samples;
}

double estimated_particles(const Scene& scene, std::size_t index) {
  const Body& body = scene.bodies[index];
  const auto solid = make_solid(body.shape, scene.dimension, scene.constants);
  const Bounds bounds = solid->bounds();
  if (!bounds.min.allFinite() || !bounds.max.allFinite()) return std::numeric_limits<double>::infinity();
  const ParticleLattice lattice(scene.grid.spacing, body.particles_per_axis, scene.dimension, bounds);
  const double more = body.sampling == "fitted" ? 2 : 1;  // cells are cut at both ends
  double within_bounds = 1;
  for (int a = 0; a < scene.dimension; ++a)
    within_bounds *= std::floor((bounds.max[a] - bounds.min[a]) / lattice.spacing()) + more;
  // Without a bound on distances all points within the bounds are looked at; and few are not worth a closer look.
  if (!solid->distance_is_bound() || within_bounds < 1e5) return within_bounds;
  // What a body of that measure holds, and a layer at its surface: a few times that of its bounds, unless it is jagged.
  double layer = 0;
  for (int a = 0; a < scene.dimension; ++a)
    layer += 2 * within_bounds / (std::floor((bounds.max[a] - bounds.min[a]) / lattice.spacing()) + 1);
  const double measure = solid->measure((bounds.max - bounds.min).maxCoeff());  // coarse: 1e-4 will do
  return std::min(within_bounds, measure / lattice.cell_measure() + 2 * layer);
}

}  // namespace pf
