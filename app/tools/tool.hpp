// Mouse tools of the view. The window turns the mouse into rays and world coordinates and hands it to the tool in
// hand; tools act on the AppContext (its Session, its selection). Middle and right drags and the wheel move the
// camera and never reach a tool, except the wheel while a tool holds something.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/context.hpp"
#include "core/charts/painter.hpp"
#include "core/types.hpp"

namespace pf::app {

/// The mouse at one moment, in the world's terms.
struct ViewMouse {
  int dimension = 2;
  Point2 pixel;                     ///< in the window, y downwards
  Vec3 origin = Vec3::Zero();       ///< of the ray under the cursor [m]; 2D: the point itself, z = 0
  Vec3 direction = -Vec3::UnitZ();  ///< of that ray, length 1, away from the viewer
  Vec3 forward = -Vec3::UnitZ();    ///< where the camera looks, length 1
  double metres_per_pixel = 0;      ///< 2D: everywhere; 3D: at the depth of the camera's target
  bool shift = false, ctrl = false, alt = false;
  /// Particle under the cursor, an index into the snapshot's arrays (not an id). Known on press and click only.
  std::optional<std::size_t> particle;

  /// Where the ray meets the plane through `point` that faces the camera. 2D: the point under the cursor.
  Vec3 on_plane(const Vec3& point) const {
    if (dimension == 2) return origin;
    const double along = direction.dot(forward);
    return along > 1e-9 ? Vec3(origin + direction * ((point - origin).dot(forward) / along)) : point;
  }
};

/// World to window, for what a tool draws over the view.
class ViewMap {
 public:
  virtual ~ViewMap() = default;
  /// Pixel of a point; nothing when it lies behind the viewer.
  virtual std::optional<Point2> to_pixel(const Vec3& point) const = 0;
  virtual double metres_per_pixel(const Vec3& at) const = 0;
  /// Pixels of one em of the interface's text: what strokes and labels are measured in.
  virtual float em() const = 0;
};

/// One thing that the left mouse button can do in the view. Only the UI thread calls it.
class Tool {
 public:
  virtual ~Tool() = default;
  /// Left button down. True: this tool holds the mouse until release() or cancel(). The press is a click as well
  /// when the button comes up again within a few pixels: click() then follows release().
  virtual bool press(const ViewMouse& mouse, AppContext& context) = 0;
  virtual void drag(const ViewMouse& mouse, AppContext& context) = 0;
  virtual void release(const ViewMouse& mouse, AppContext& context) = 0;
  virtual void click(const ViewMouse& mouse, AppContext& context) = 0;
  /// Wheel while the tool holds the mouse; true when it was used (a grab's radius), else the camera zooms.
  virtual bool wheel(float notches, const ViewMouse& mouse, AppContext& context) = 0;
  /// Let go of everything: Esc, reset, another scene, the window lost focus.
  virtual void cancel(AppContext& context) = 0;
  /// What can be chosen for it, as widgets beside the tool bar; false where there is nothing to choose.
  virtual bool has_options() const { return false; }
  virtual void draw_options(AppContext& /*context*/) {}
  /// Over the view, under the panels. `mouse` is absent while the cursor is elsewhere.
  virtual void draw(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context) = 0;
};

struct ToolInfo {
  const char* key;    ///< stable name, for preferences
  const char* label;  ///< plain name: "Grab"
  const char* help;   ///< one sentence: what the mouse does
  std::unique_ptr<Tool> (*make)();
  bool flat_only = false;  ///< of no use in 3D
};
/// Every tool, the default first (explicit table in tools.cpp).
const std::vector<ToolInfo>& tools();

}  // namespace pf::app
