// What every layer needs to draw one frame. Internal to render/.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "render/gl_objects.hpp"
#include "render/program.hpp"
#include "render/renderer.hpp"

namespace pf {

/// In world axes; as in shaders/common.glsl.
inline const glm::vec3 towards_light = glm::normalize(glm::vec3(-0.362f, 0.805f, 0.470f));

/// Shaders see coordinates relative to `origin` (the camera's centre or target), subtracted in double: a body far
/// from the world's origin is drawn as exactly as one beside it.
struct Frame {
  Frame(const Snapshot& drawn, const RenderOptions& how, const Camera& from, const Viewport& where, bool on_cpu)
      : snapshot(drawn), options(how), camera(from), viewport(where), software(on_cpu) {}

  const Snapshot& snapshot;
  const RenderOptions& options;
  const Camera& camera;
  Viewport viewport;
  bool software;

  Vec3 origin = Vec3::Zero();
  glm::mat4 view_projection{1};
  double pixels_per_metre = 1;  ///< at the origin
  ValueRange range;             ///< of the colour map

  const RenderTheme& theme() const { return options.theme; }
  bool flat() const { return std::holds_alternative<Camera2D>(camera); }
  float scale() const { return options.pixel_scale; }
  glm::vec2 size() const { return {viewport.size.width, viewport.size.height}; }
  ColorScale color_scale() const { return pf::color_scale(options); }
  /// What shown_value() has at the ends of the colour map.
  glm::vec2 shown_range() const {
    if (color_scale() != ColorScale::logarithmic) return {range.min, range.max};
    return {std::log10(range.min), std::log10(range.max)};
  }
  /// Size of the view [m].
  double extent() const { return std::max(viewport.size.width, viewport.size.height) / pixels_per_metre; }
};

/// The world point that uploaded coordinates are relative to. It is kept while the camera moves, as long as
/// single precision still places points within a tenth of a pixel.
class Anchor {
 public:
  bool serves(const Frame& frame) const { return known_ && (at_ - frame.origin).norm() < 500 * frame.extent(); }
  void drop_at(const Frame& frame) {
    at_ = frame.origin;
    known_ = true;
  }
  const Vec3& at() const { return at_; }
  glm::vec3 offset(const Frame& frame) const {
    const Vec3 d = at_ - frame.origin;
    return {d.x(), d.y(), d.z()};
  }

 private:
  Vec3 at_ = Vec3::Zero();
  bool known_ = false;
};

/// Tells whether uploaded data still are the snapshot's. Pooled snapshots keep their address, so more is compared.
struct DataKey {
  const Snapshot* snapshot = nullptr;
  const SceneView* scene = nullptr;
  long step = -1, strokes = 0;
  double time = 0;
  std::size_t particles = 0, nodes = 0, values = 0;
  Field field = Field::speed;
  double extra = 0;          ///< whatever else a layer's data depend on
  bool logarithmic = false;  ///< values are uploaded as logarithms
  bool operator==(const DataKey&) const = default;

  static DataKey of(const Frame& f, double extra = 0) {
    const Snapshot& s = f.snapshot;
    return {&s,
            s.scene.get(),
            s.report.step,
            s.report.strokes.count,
            s.report.time,
            s.particles,
            s.nodes,
            s.field[static_cast<std::size_t>(f.options.field)].size(),
            f.options.field,
            extra,
            color_scale(f.options) == ColorScale::logarithmic};
  }
};

struct Rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
};
inline Rgba8 rgba8(const Color& c) {
  const auto byte = [](float v) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.f, 1.f))); };
  return {byte(c.r), byte(c.g), byte(c.b), byte(c.a)};
}

/// `world` relative to `anchor`, in single precision.
inline glm::vec3 relative(const Vec3& world, const Anchor& anchor) {
  const Vec3 d = world - anchor.at();
  return {d.x(), d.y(), d.z()};
}
/// Components of entry k of an interleaved array; z = 0 in 2D.
template <class T>
Vec3 component_vector(const std::vector<T>& array, std::size_t k, int dimension) {
  const T* at = array.data() + k * static_cast<std::size_t>(dimension);
  return {static_cast<double>(at[0]), static_cast<double>(at[1]), dimension == 3 ? static_cast<double>(at[2]) : 0.0};
}

}  // namespace pf
