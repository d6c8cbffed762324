#include "render/cross_layer.hpp"

#include <Eigen/Eigenvalues>
#include <limits>
#include <unordered_map>

namespace pf {

namespace {

constexpr double spacing_pixels = 30;  ///< between crosses, layout pixels
constexpr double longest = 1.5;        ///< of an outlier's line, in lines of the reference stress

Mat3 stress_of(const Snapshot& s, std::size_t p) {
  const float* c = s.stress.data() + 6 * p;
  Mat3 sigma;
  sigma << c[0], c[3], c[5], c[3], c[1], c[4], c[5], c[4], c[2];
  return sigma;
}

struct Principal {
  std::array<double, 3> value{};
  std::array<Vec3, 3> direction{};
  int count = 0;
};
/// In 2D of the plane alone.
Principal principal(const Snapshot& s, std::size_t p) {
  Principal out;
  const Mat3 sigma = stress_of(s, p);
  if (!sigma.allFinite()) return out;
  out.count = s.dimension;
  if (s.dimension == 2) {
    Eigen::SelfAdjointEigenSolver<Mat<2>> solver;
    solver.computeDirect(sigma.topLeftCorner<2, 2>());
    for (int k = 0; k < 2; ++k) {
      out.value[static_cast<std::size_t>(k)] = solver.eigenvalues()[k];
      out.direction[static_cast<std::size_t>(k)] = {solver.eigenvectors()(0, k), solver.eigenvectors()(1, k), 0};
    }
    return out;
  }
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(sigma);
  for (int k = 0; k < 3; ++k) {
    out.value[static_cast<std::size_t>(k)] = solver.eigenvalues()[k];
    out.direction[static_cast<std::size_t>(k)] = solver.eigenvectors().col(k);
  }
  return out;
}

std::uint64_t square(double x, double y, double side) {
  const auto part = [side](double v) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(v / side)));
  };
  return static_cast<std::uint64_t>(part(x)) << 32 | part(y);
}

}  // namespace

Color tension_color(const RenderTheme& theme) {
  return theme == RenderTheme::light() ? Color{0.80f, 0.10f, 0.10f} : Color{1.0f, 0.42f, 0.36f};
}
Color compression_color(const RenderTheme& theme) {
  return theme == RenderTheme::light() ? Color{0.05f, 0.30f, 0.80f} : Color{0.45f, 0.72f, 1.0f};
}

void CrossLayer::invalidate() {
  key_ = {};
  scene_ = nullptr;
  reference_ = 0;
}

bool CrossLayer::still_serves(const Frame& frame) const {
  if (scene_ != frame.snapshot.scene.get() || !scene_) return false;
  const double scaled = frame.pixels_per_metre / chosen_scale_;
  return scaled > 0.7 && scaled < 1.4 && (frame.origin - chosen_origin_).norm() < 0.4 * frame.extent();
}

void CrossLayer::choose_flat(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  scene_ = s.scene.get();
  chosen_origin_ = frame.origin;
  chosen_scale_ = frame.pixels_per_metre;
  std::uint32_t last = 0;  // ids have gaps where particles were cut away
  for (const std::uint32_t id : s.id) last = std::max(last, id);
  const std::size_t ids = s.particles == 0 ? 0 : std::size_t{last} + 1;
  chosen_id_.assign(ids, 0);
  const double apart = spacing_pixels * static_cast<double>(frame.scale()) / frame.pixels_per_metre;
  const double reach = frame.extent();
  std::unordered_map<std::uint64_t, std::vector<Vec3>> taken;
  std::vector<std::size_t> by_id(ids, s.particles);
  for (std::size_t p = 0; p < s.particles; ++p) by_id[s.id[p]] = p;
  for (const std::size_t p : by_id) {
    if (p == s.particles) continue;
    const Vec3 x = component_vector(s.x, p, 2);
    if (!x.allFinite() || (x - frame.origin).cwiseAbs().maxCoeff() > reach) continue;
    bool free = true;
    for (int i = -1; i <= 1 && free; ++i)
      for (int j = -1; j <= 1 && free; ++j) {
        const auto near = taken.find(square(x.x() + i * apart, x.y() + j * apart, apart));
        if (near == taken.end()) continue;
        for (const Vec3& other : near->second) free = free && (other - x).norm() >= apart;
      }
    if (!free) continue;
    taken[square(x.x(), x.y(), apart)].push_back(x);
    chosen_id_[s.id[p]] = 1;
  }
}

void CrossLayer::choose_foremost(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  struct Best {
    double depth = std::numeric_limits<double>::infinity();
    std::size_t particle = 0;
  };
  const double side = 1.2 * spacing_pixels * static_cast<double>(frame.scale());
  std::unordered_map<std::uint64_t, Best> squares;
  const auto half = 0.5 * glm::dvec2(frame.size());
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vec3 d = component_vector(s.x, p, 3) - frame.origin;
    const glm::vec4 at = frame.view_projection * glm::vec4(d.x(), d.y(), d.z(), 1);
    if (!(at.w > 0) || std::abs(at.x) > at.w || std::abs(at.y) > at.w) continue;
    const double x = half.x * static_cast<double>(at.x / at.w), y = half.y * static_cast<double>(at.y / at.w);
    // A little further back is better than at the square's edge, where the next one's cross begins.
    const double off =
        std::max(std::abs(x / side - std::floor(x / side) - 0.5), std::abs(y / side - std::floor(y / side) - 0.5)) *
        side / frame.pixels_per_metre;
    Best& best = squares[square(x, y, side)];
    const double depth = static_cast<double>(at.w) + off;
    if (depth < best.depth) best = {depth, p};
  }
  chosen_.clear();
  for (const auto& [where, best] : squares) chosen_.push_back(best.particle);
  std::sort(chosen_.begin(), chosen_.end());
}

void CrossLayer::upload(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  anchor_.drop_at(frame);
  if (frame.flat()) {
    if (!still_serves(frame)) choose_flat(frame);
    chosen_.clear();
    for (std::size_t p = 0; p < s.particles; ++p)
      if (s.id[p] < chosen_id_.size() && chosen_id_[s.id[p]] != 0) chosen_.push_back(p);
  } else {
    choose_foremost(frame);
  }
  std::vector<Principal> crosses;
  std::vector<double> largest;
  for (const std::size_t p : chosen_) {
    crosses.push_back(principal(s, p));
    double most = 0;
    for (const double value : crosses.back().value) most = std::max(most, std::abs(value));
    largest.push_back(most);
  }
  if (!largest.empty()) {
    const auto at = largest.begin() + static_cast<std::ptrdiff_t>(0.85 * static_cast<double>(largest.size() - 1));
    std::nth_element(largest.begin(), at, largest.end());
    reference_ = std::max(*at, 0.97 * reference_);
  }
  const double full = 0.95 * spacing_pixels * static_cast<double>(frame.scale());  // [px]
  pixels_per_pascal_ = reference_ > 0 ? full / reference_ : 0;
  const Rgba8 pull = rgba8(tension_color(frame.theme())), push = rgba8(compression_color(frame.theme()));
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < chosen_.size() && reference_ > 0; ++k) {
    const Vec3 x = component_vector(s.x, chosen_[k], s.dimension);
    for (int a = 0; a < crosses[k].count; ++a) {
      const auto i = static_cast<std::size_t>(a);
      const double pixels = full * std::min(longest, std::abs(crosses[k].value[i]) / reference_);
      if (pixels < 1.5 * static_cast<double>(frame.scale())) continue;
      const Vec3 arm = 0.5 * pixels / frame.pixels_per_metre * crosses[k].direction[i];
      segments.push_back(
          {relative(x - arm, anchor_), relative(x + arm, anchor_), crosses[k].value[i] > 0 ? pull : push});
    }
  }
  lines_.upload(segments, {});
}

void CrossLayer::draw(const Frame& frame, InkPrograms& ink) {
  const Snapshot& s = frame.snapshot;
  if (!frame.options.stress_crosses || s.stress.size() != 6 * s.particles || s.id.size() != s.particles) {
    pixels_per_pascal_ = 0;
    return;
  }
  const DataKey key = DataKey::of(frame, frame.pixels_per_metre);
  const bool moved = !(camera_ == frame.camera) || size_ != frame.viewport.size;
  if (key != key_ || !anchor_.serves(frame) || (moved && (!frame.flat() || !still_serves(frame)))) upload(frame);
  key_ = key;
  camera_ = frame.camera;
  size_ = frame.viewport.size;
  lines_.draw(ink, frame, anchor_, 1.7f, 0, frame.theme().arrow_rim);
}

}  // namespace pf
