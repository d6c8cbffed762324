#include "render/surface_mesh.hpp"

#include <array>
#include <cmath>

namespace pf {

namespace {

using Distance = std::function<double(const Vec3&)>;

Vec3 gradient(const Distance& distance, const Vec3& p, double h) {
  Vec3 g;
  for (int a = 0; a < 3; ++a) g[a] = (distance(p + h * Vec3::Unit(a)) - distance(p - h * Vec3::Unit(a))) / (2 * h);
  return g;
}

/// The lattice of samples.
struct Samples {
  std::array<int, 3> cells;
  Vec3 min, pitch;
  std::vector<float> values;

  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * (cells[1] + 1) + j) * (cells[0] + 1) + i;
  }
  Vec3 at(int i, int j, int k) const { return min + pitch.cwiseProduct(Vec3(i, j, k)); }
};

Samples sample_lattice(const Distance& distance, const ViewBounds& bounds, int resolution) {
  Samples s;
  const double pitch = bounds.size().maxCoeff() / resolution;
  s.min = bounds.min;
  for (int a = 0; a < 3; ++a) {
    s.cells[a] = std::max(1, static_cast<int>(std::ceil(bounds.size()[a] / pitch - 1e-9)));
    s.pitch[a] = bounds.size()[a] / s.cells[a];
  }
  s.values.resize(s.index(0, 0, s.cells[2] + 1));
  for (int k = 0; k <= s.cells[2]; ++k)
    for (int j = 0; j <= s.cells[1]; ++j)
      for (int i = 0; i <= s.cells[0]; ++i) s.values[s.index(i, j, k)] = static_cast<float>(distance(s.at(i, j, k)));
  return s;
}

/// Appends the surface inside one tetrahedron.
class Mesher {
 public:
  Mesher(const Distance& distance, double step, std::vector<SurfaceVertex>& out)
      : distance_(distance), step_(step), out_(out) {}

  void tetrahedron(const std::array<Vec3, 4>& p, const std::array<float, 4>& d) {
    std::array<int, 4> in{}, outside{};
    int n = 0, m = 0;
    for (int k = 0; k < 4; ++k) (d[k] < 0 ? in[n++] : outside[m++]) = k;
    const auto cut = [&](int a, int b) { return vertex(p[a] + (p[b] - p[a]) * (d[a] / (d[a] - d[b]))); };
    if (n == 1 || n == 3) {
      const int lone = n == 1 ? in[0] : outside[0];
      const auto& others = n == 1 ? outside : in;
      triangle(cut(lone, others[0]), cut(lone, others[1]), cut(lone, others[2]));
    } else if (n == 2) {
      const SurfaceVertex a = cut(in[0], outside[0]), b = cut(in[0], outside[1]);
      const SurfaceVertex c = cut(in[1], outside[1]), e = cut(in[1], outside[0]);
      triangle(a, b, c);
      triangle(a, c, e);
    }
  }

 private:
  SurfaceVertex vertex(Vec3 p) const {
    Vec3 g = gradient(distance_, p, 0.05 * step_);
    const double length = g.norm();
    if (!(length > 1e-9)) return {p, Vec3::UnitY()};
    const double d = distance_(p) / length;
    if (std::abs(d) < step_) p -= d * g / length;
    return {p, g / length};
  }
  void triangle(const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c) {
    out_.insert(out_.end(), {a, b, c});
  }

  const Distance& distance_;
  double step_;
  std::vector<SurfaceVertex>& out_;
};

}  // namespace

std::vector<SurfaceVertex> surface_mesh(const Distance& distance, const ViewBounds& bounds, int resolution) {
  std::vector<SurfaceVertex> mesh;
  if (!bounds.min.allFinite() || !bounds.max.allFinite() || bounds.size().maxCoeff() <= 0) return mesh;
  const Samples s = sample_lattice(distance, bounds, resolution);
  Mesher mesher(distance, s.pitch.maxCoeff(), mesh);
  // Six tetrahedra around the cell's diagonal 0-7; bit a of a corner's number is its place in direction a.
  constexpr int tetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  for (int k = 0; k < s.cells[2]; ++k) {
    for (int j = 0; j < s.cells[1]; ++j) {
      for (int i = 0; i < s.cells[0]; ++i) {
        std::array<float, 8> d;
        int inside = 0;
        for (int c = 0; c < 8; ++c) {
          d[c] = s.values[s.index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2))];
          inside += d[c] < 0;
        }
        if (inside == 0 || inside == 8) continue;
        for (const auto& t : tetrahedra) {
          std::array<Vec3, 4> p;
          for (int v = 0; v < 4; ++v) p[v] = s.at(i + (t[v] & 1), j + (t[v] >> 1 & 1), k + (t[v] >> 2));
          mesher.tetrahedron(p, {d[t[0]], d[t[1]], d[t[2]], d[t[3]]});
        }
      }
    }
  }
  return mesh;
}

std::optional<Plane> as_plane(const BoundaryView& solid, const ViewBounds& near) {
  const bool bounded = solid.min.allFinite() && solid.max.allFinite();
  if (bounded || !solid.distance) return std::nullopt;
  const double reach = std::max(near.size().maxCoeff(), 1e-9);
  const Vec3 centre = near.centre();
  const double d0 = solid.distance(centre);
  const Vec3 g = gradient(solid.distance, centre, 0.01 * reach);
  if (!std::isfinite(d0) || std::abs(g.norm() - 1) > 1e-6) return std::nullopt;
  for (int c = 0; c < 8; ++c) {
    for (const double far : {1.0, 10.0}) {
      const Vec3 q = far * reach * Vec3(c & 1 ? 1 : -0.9, c & 2 ? 0.8 : -1, c & 4 ? 0.7 : -1.1);
      if (std::abs(solid.distance(centre + q) - d0 - g.dot(q)) > 1e-6 * far * reach) return std::nullopt;
    }
  }
  return Plane{centre - d0 * g, g};
}

}  // namespace pf
