#include "render/distance_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pf {

namespace {

constexpr int block = 8;         // samples a side of a coarse cell
constexpr double nothing = 1e6;  // [px] where a scene has no such thing
using Distance = std::function<double(const Vec3&)>;

/// The members of one channel, each with its displacement.
struct Channel {
  std::vector<std::pair<const Distance*, Vec3>> members;
  double operator()(const Vec3& p) const {
    double least = INFINITY;
    for (const auto& [distance, shift] : members) least = std::min(least, (*distance)(p - shift));
    return least;
  }
};

std::array<Channel, 3> channels(const Snapshot& s) {
  std::array<Channel, 3> c;
  for (std::size_t b = 0; b < s.scene->boundaries.size(); ++b) {
    const Vec3 shift = b < s.boundary_displacement.size() ? s.boundary_displacement[b] : Vec3::Zero();
    if (s.scene->boundaries[b].distance) c[0].members.emplace_back(&s.scene->boundaries[b].distance, shift);
  }
  for (const RegionView& r : s.scene->regions)
    if (r.distance) c[r.kind == "load" ? 2 : 1].members.emplace_back(&r.distance, Vec3::Zero());
  return c;
}

/// Fills one channel of `map`.
class Sampler {
 public:
  Sampler(DistanceMap& map, const Camera2D& camera, ViewSize size, const Channel& channel, std::size_t index)
      : map_(map), camera_(camera), size_(size), channel_(channel), index_(index) {}

  void run() {
    for (int j = 0; j < map_.rows; j += block)
      for (int i = 0; i < map_.columns; i += block) fill(i, j);
  }

 private:
  float evaluate(int i, int j) const {
    const Vec3 p = camera_.to_world({i * map_.pitch, size_.height - j * map_.pitch}, size_);
    const double d = channel_(p) * camera_.pixels_per_metre;
    return static_cast<float>(std::isnan(d) ? nothing : std::clamp(d, -nothing, nothing));
  }
  float& value(int i, int j) { return map_.values[3 * (static_cast<std::size_t>(j) * map_.columns + i) + index_]; }

  void fill(int i0, int j0) {
    const float d00 = evaluate(i0, j0), d10 = evaluate(i0 + block, j0);
    const float d01 = evaluate(i0, j0 + block), d11 = evaluate(i0 + block, j0 + block);
    const float nearest = std::min({std::abs(d00), std::abs(d10), std::abs(d01), std::abs(d11)});
    const bool same_sign = (d00 > 0) == (d10 > 0) && (d00 > 0) == (d01 > 0) && (d00 > 0) == (d11 > 0);
    // No point of the cell is farther than half its diagonal from a corner, and distance changes by at most 1 a
    // pixel; the rest is room for the lines beside the surface.
    const bool far = same_sign && nearest > 0.75 * std::sqrt(2.0) * block * map_.pitch + 4;
    for (int j = j0; j < std::min(j0 + block, map_.rows); ++j) {
      for (int i = i0; i < std::min(i0 + block, map_.columns); ++i) {
        const float u = static_cast<float>(i - i0) / block, v = static_cast<float>(j - j0) / block;
        value(i, j) = far ? (1 - v) * ((1 - u) * d00 + u * d10) + v * ((1 - u) * d01 + u * d11) : evaluate(i, j);
      }
    }
  }

  DistanceMap& map_;
  const Camera2D& camera_;
  ViewSize size_;
  const Channel& channel_;
  std::size_t index_;
};

}  // namespace

DistanceMap DistanceMap::sample(const Snapshot& snapshot, const Camera2D& camera, ViewSize size, double pitch) {
  DistanceMap map;
  map.pitch = pitch;
  map.columns = static_cast<int>(std::ceil(size.width / pitch)) + 2;
  map.rows = static_cast<int>(std::ceil(size.height / pitch)) + 2;
  map.values.assign(3 * static_cast<std::size_t>(map.columns) * map.rows, static_cast<float>(nothing));
  if (!snapshot.scene) return map;
  const std::array<Channel, 3> all = channels(snapshot);
  map.solids = !all[0].members.empty();
  map.regions = !all[1].members.empty() || !all[2].members.empty();
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!all[k].members.empty()) Sampler(map, camera, size, all[k], k).run();
  return map;
}

}  // namespace pf
