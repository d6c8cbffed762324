// A snapshot -> pixels of the current OpenGL 3.3 framebuffer. Knows no simulation and no window.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/snapshot.hpp"
#include "render/camera.hpp"
#include "render/color_range.hpp"
#include "render/theme.hpp"

namespace pf {

struct RenderOptions {
  Field field = Field::speed;
  std::optional<ValueRange> range;  ///< of the colour map; absent: AutoRange
  bool logarithmic = false;         ///< colours by the magnitude's logarithm
  std::optional<bool> symmetric;    ///< about the field's centre; nothing: as the field is
  bool particles = true;
  bool deformed = true;     ///< squares / ellipsoids mapped by F; else round points / spheres
  bool grid = false;        ///< lattice, active cells and nodes
  bool velocities = false;  ///< node velocities as arrows
  bool bent_grid = false;   ///< images of the grid lines under phi^
  double bent_magnification = 1;
  bool stress_crosses = false;  ///< principal stresses as lines along their directions
  bool boundaries = true;
  bool regions = true;                    ///< constraints and loads
  bool shadows = true;                    ///< 3D; never on a software renderer unless `best_quality`
  bool best_quality = false;              ///< pictures: every effect and no cheap points, whatever the time
  bool transparent = false;               ///< nothing behind material and walls: colours multiplied by their alpha
  bool in_motion = false;                 ///< a software renderer may draw less exactly: the next picture is near
  std::optional<std::uint32_t> selected;  ///< id of a particle
  float pixel_scale = 1;                  ///< framebuffer pixels per layout pixel: scales line widths and dots
  RenderTheme theme = RenderTheme::dark();
  bool operator==(const RenderOptions&) const = default;
};

/// Lower left corner and size, in framebuffer pixels, as glViewport takes them.
struct Viewport {
  int x = 0, y = 0;
  ViewSize size;
};

/// How the field of `options` becomes colours.
inline ColorScale color_scale(const RenderOptions& options) {
  return color_scale(field_info(options.field), options.logarithmic, options.symmetric);
}

/// Create, use and destroy with the same OpenGL context current. Throws std::runtime_error when the context is
/// older than 3.3 or a shader does not compile.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Fills `viewport` of the framebuffer that is bound. Uploads only what changed since the last call (told by
  /// the snapshot's address, step, time and scene). Restores framebuffer and viewport; other OpenGL state is left
  /// at its defaults.
  void draw(const Snapshot& snapshot, const RenderOptions& options, const Camera& camera, const Viewport& viewport);

  /// Range of the colour map in the last draw(): what the colour bar shows.
  ValueRange range() const;
  /// The automatic range begins anew: after a reset or another scene.
  void forget_range();
  /// The next draw() uploads everything again.
  void invalidate();
  /// Rendered on the CPU (llvmpipe and the like).
  bool software() const;
  /// Pixels that an arrow of 1 m/s was long in the last draw(); 0 when none was drawn.
  double arrow_pixels_per_speed() const;
  /// The same of a stress cross's whole line and 1 Pa.
  double cross_pixels_per_pascal() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Empties OpenGL's queue of errors and names them; empty when there was none.
std::string take_gl_errors();

}  // namespace pf
