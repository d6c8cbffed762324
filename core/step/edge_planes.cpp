#include "core/step/edge_planes.hpp"

#include <cmath>
#include <memory>

#include "core/scene/solid.hpp"
#include "core/step/formulas.hpp"

namespace pf {

namespace {

/// Shares of dx: how near to a plane of nodes a face must be, and how far inside of it nothing is held any more.
constexpr double on_plane = 1e-6, inside = 0.01;

template <int D>
struct Extent {
  Vec<D> low, high;
};

template <int D>
class PlaneSearch {
 public:
  PlaneSearch(const Scene& scene, const Particles<D>& particles) : scene_(scene), particles_(particles) {
    extent_.low.setConstant(1e300);
    extent_.high.setConstant(-1e300);
    for (const Vec<D>& X : particles.X) {
      extent_.low = extent_.low.cwiseMin(X);
      extent_.high = extent_.high.cwiseMax(X);
    }
  }

  void add(const Shape& shape, bool invert) {
    if (shape.rotate_degrees != 0 || (shape.type != "box" && shape.type != "half_space")) return;
    const std::unique_ptr<Solid> solid = make_solid(shape, D, scene_.constants);
    for (int a = 0; a < D; ++a) {
      if (shape.type == "half_space") {
        if (std::abs(shape.normal[a]) == shape.normal.norm())
          face(*solid, invert, a, shape.point[a] + shape.translate[a]);
        continue;
      }
      const Bounds bounds = solid->bounds();
      face(*solid, invert, a, bounds.min[a]);
      face(*solid, invert, a, bounds.max[a]);
    }
  }

  std::array<EdgePlanes, D> planes{};

 private:
  void face(const Solid& solid, bool invert, int a, double coordinate) {
    const double dx = scene_.grid.spacing, tolerance = on_plane * dx;
    if (!std::isfinite(coordinate) || std::abs(coordinate) > 1e15 * dx) return;
    const auto plane = static_cast<long long>(std::round(coordinate / dx));
    if (std::abs(coordinate - static_cast<double>(plane) * dx) > tolerance) return;
    EdgePlanes& found = planes[static_cast<std::size_t>(a)];
    if (extent_.low[a] >= coordinate - tolerance && (!found.low || *found.low < plane) &&
        holds(solid, invert, a, coordinate, inside * dx))
      found.low = plane;
    if (extent_.high[a] <= coordinate + tolerance && (!found.high || *found.high > plane) &&
        holds(solid, invert, a, coordinate, -inside * dx))
      found.high = plane;
  }

  /// Whether the solid holds the plane but not what is just inside, anywhere beside the bodies.
  bool holds(const Solid& solid, bool invert, int a, double coordinate, double inward) const {
    std::vector<Vec3> normals;
    const auto held = [&](const Vec3& x) {
      normals.clear();
      solid.contact_normals(x, invert, 1e-9 * scene_.grid.spacing, normals);
      return !normals.empty();
    };
    for (const Vec<D>& X : particles_.X) {
      Vec3 x = Vec3::Zero();
      x.head<D>() = X;
      x[a] = coordinate;
      if (!held(x)) continue;
      x[a] += inward;
      if (!held(x)) return true;
    }
    return false;
  }

  const Scene& scene_;
  const Particles<D>& particles_;
  Extent<D> extent_;
};

}  // namespace

template <int D>
std::array<EdgePlanes, D> edge_planes(const Scene& scene, const Particles<D>& particles) {
  if (!scene.grid.boundary_correction) return {};
  PlaneSearch<D> search(scene, particles);
  for (const Boundary& b : scene.boundaries)
    if (FormulaField<D>(b.velocity, scene.constants, mask_time).zero()) search.add(b.shape, b.invert);
  for (const Constraint& c : scene.constraints) search.add(c.region, false);
  for (EdgePlanes& p : search.planes)
    if (p.low && p.high && *p.high - *p.low < 2) p.high.reset();  // they would share the nodes that change
  return search.planes;
}

template std::array<EdgePlanes, 2> edge_planes<2>(const Scene&, const Particles<2>&);
template std::array<EdgePlanes, 3> edge_planes<3>(const Scene&, const Particles<3>&);

}  // namespace pf
