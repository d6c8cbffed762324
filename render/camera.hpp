// Where the picture is looked at from. World coordinates are doubles in metres; pixels count from the upper left
// corner of the viewport, y downwards, and may lie outside it.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "core/snapshot.hpp"

namespace pf {

/// Size of the drawn area in framebuffer pixels.
struct ViewSize {
  int width = 1, height = 1;
  bool operator==(const ViewSize&) const = default;
};
/// Axis-aligned bounds [m] of what is to be seen. In 2D only x and y count.
struct ViewBounds {
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();
  Vec3 centre() const { return 0.5 * (min + max); }
  Vec3 size() const { return max - min; }
};
/// Blank margins around fitted content, in pixels: room for the overlay.
struct ViewMargins {
  double left = 0, right = 0, top = 0, bottom = 0;
  /// What stands in the lower corners, and the margin between them: another way to keep clear of it than `bottom`
  /// (settled). 0: there is none.
  double left_corner = 0, right_corner = 0, between = 0;

  ViewMargins scaled(double across, double along) const {
    return {across * left,        across * right,        along * top,    along * bottom,
            across * left_corner, across * right_corner, along * between};
  }
};

/// Looks straight at the x-y plane; y points upwards on the screen.
struct Camera2D {
  Vec<2> centre = Vec<2>::Zero();  ///< world point in the middle of the viewport [m]
  double pixels_per_metre = 100;

  Vec<2> to_pixel(const Vec3& world, ViewSize size) const;
  Vec3 to_world(const Vec<2>& pixel, ViewSize size) const;
  /// Moves the content by `pixels`, as a drag does.
  void pan(const Vec<2>& pixels);
  /// Scales by `factor` about `pixel`, which keeps showing the same world point.
  void zoom(double factor, const Vec<2>& pixel, ViewSize size);
  /// Shows all of `bounds` as large as the margins allow.
  void fit(const ViewBounds& bounds, ViewSize size, const ViewMargins& margins = {});
  bool operator==(const Camera2D&) const = default;
};

/// Turntable around `target` with y upwards; perspective.
struct OrbitCamera {
  Vec3 target = Vec3::Zero();  ///< world point in the middle of the viewport [m]
  double distance = 5;         ///< of the eye from the target [m]
  double yaw = 0.6;            ///< [rad], 0: the eye is on the +z side, positive towards +x
  double pitch = 0.35;         ///< [rad], elevation of the eye, in (-pi/2, pi/2)
  double field_of_view = 0.6;  ///< vertical [rad]

  Vec3 eye() const;
  /// Unit vectors of the screen: right, up, and forward (from the eye to the target).
  Vec3 right() const;
  Vec3 up() const;
  Vec3 forward() const;
  /// Empty behind the eye.
  std::optional<Vec<2>> to_pixel(const Vec3& world, ViewSize size) const;
  /// Unit direction from the eye through `pixel`.
  Vec3 ray(const Vec<2>& pixel, ViewSize size) const;
  /// Point under `pixel` in the plane through `through` parallel to the screen: what a mouse drag means in 3D.
  Vec3 to_world(const Vec<2>& pixel, ViewSize size, const Vec3& through) const;
  /// Pixels a metre at the target's depth.
  double pixels_per_metre(ViewSize size) const;
  void rotate(double yaw_by, double pitch_by);
  void pan(const Vec<2>& pixels, ViewSize size);
  /// Factor > 1 goes closer.
  void zoom(double factor);
  void fit(const ViewBounds& bounds, ViewSize size, const ViewMargins& margins = {});
  bool operator==(const OrbitCamera&) const = default;
};

using Camera = std::variant<Camera2D, OrbitCamera>;

/// A camera of the right kind for `dimension`, showing all of `bounds`.
/// Above what stands in the lower corners or between it: whichever shows `bounds` larger.
ViewMargins settled(const ViewMargins& margins, const Camera& camera, const ViewBounds& bounds, ViewSize size);
Camera fitted_camera(int dimension, const ViewBounds& bounds, ViewSize size, const ViewMargins& margins = {});
/// Empty behind an orbit camera's eye.
std::optional<Vec<2>> to_pixel(const Camera& camera, const Vec3& world, ViewSize size);

/// Index (not id) of the particle under `pixel`, or within `reach` pixels of it; the foremost one in 3D.
std::optional<std::size_t> pick_particle(const Snapshot& snapshot, const Camera& camera, ViewSize size,
                                         const Vec<2>& pixel, double reach = 6);

/// Smallest box around all particles (with their own extent); empty snapshot: unit box about the origin.
ViewBounds particle_bounds(const Snapshot& snapshot);
/// `seen` with `body` inside of it, as far as that leaves it within 1.5 `size` of its centre: a body that flies away
/// does not take the view with it.
ViewBounds widened(const ViewBounds& seen, const ViewBounds& body, double size);
/// What a person wants to see from the first frame to the last: the particles, the finite boundaries near
/// them, and the way down to a floor on which they fall.
ViewBounds scene_bounds(const Snapshot& first);

}  // namespace pf
