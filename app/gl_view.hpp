// The view: draws the newest snapshot with render/, moves the camera and feeds the mouse to the tool in hand.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "app/color_bar_control.hpp"
#include "app/context.hpp"
#include "app/layout.hpp"
#include "app/tools/tool.hpp"
#include "core/charts/image.hpp"
#include "render/camera.hpp"
#include "render/offscreen.hpp"
#include "render/renderer.hpp"

struct ImDrawList;

namespace pf::app {

/// Render's options for what the user chose to see. `pixel_scale`: framebuffer pixels per layout pixel.
RenderOptions render_options(const AppContext& context, float pixel_scale);
/// A picture of the view for a file.
struct PictureRequest {
  ViewSize size{0, 0};       ///< [pixels]; 0: as the view, at least 1600 wide
  bool as_view = false;      ///< as the view, to the pixel
  bool overlay = true;       ///< title, clock, colour bar, scale, axes
  bool transparent = false;  ///< nothing behind material and walls
};
/// Needs a current OpenGL context from construction to destruction; the UI thread's.
class GlView {
 public:
  GlView();

  /// Where the view is. `pixels_per_unit`: framebuffer pixels per unit of `where`. `margins`: of fitted content, in
  /// units of the overlay, where there is more over it than the overlay.
  void place(const Rect& where, float pixels_per_unit, float framebuffer_height,
             const std::optional<ViewMargins>& margins = {});
  /// Draws into the framebuffer, or copies the last picture to it where nothing changed: a menu that opens over a
  /// large scene need not draw it again. Before ImGui draws over it.
  void draw(const AppContext& context);
  /// Moves the camera as draw() would, where somebody else draws through it.
  void aim(const AppContext& context);
  /// Inside of ImGui's frame: camera and tools; while lanes are compared the camera alone.
  void handle_mouse(AppContext& context);
  /// The tool's marks, clock, scale, axes and colour bar, on `list`.
  void draw_overlay(AppContext& context, ImDrawList& list);

  /// The view without panels, in the best quality.
  Image picture(const AppContext& context, const PictureRequest& request = {});

  /// For a picture of this size [pixels]: while the view's camera is the fitted one, fitted anew with `margins` [units
  /// of the overlay, `scale` pixels each]; else it shows what the view does, and more where the picture has another
  /// shape.
  Camera picture_camera(ViewSize picture, const ViewMargins& margins, double scale) const;
  /// Shows everything that matters from the next snapshot on; until the user moves the camera it follows the size.
  void fit() { fit_wanted_ = true; }
  /// Another run begins: the colour range starts anew, the tool lets go.
  void begin_run(AppContext& context);
  void cancel_tool(AppContext& context);
  /// Drawn by the processor, not by a graphics card.
  bool software() const { return renderer_.software(); }
  /// Seconds until the last picture, drawn in haste, deserves a better one; nothing when it is as good as can be.
  std::optional<double> refines_in() const;
  const ColorBarControl& color_bar() const { return color_bar_; }
  bool tool_holds() const { return held_; }
  /// The one in hand; null where there is none.
  Tool* tool() { return tools_.empty() ? nullptr : tools_[tool_].get(); }
  const Camera& camera() const { return camera_; }
  const Rect& place() const { return where_; }
  ViewSize size() const { return size_; }
  /// Where a point of the world is in the window, as the last draw() showed it.
  std::optional<Point2> to_window(const Vec3& point) const;

 private:
  using Clock = std::chrono::steady_clock;
  friend class CameraMap;
  /// How many values there are along the colour bar, counted once a picture.
  const std::vector<float>& counts(const AppContext& context, const OverlayInfo& info);
  void draw_tool(AppContext& context, ImDrawList& list);
  ViewMouse mouse_now(const AppContext& context, bool pick) const;
  Vec<2> to_view_pixel(Point2 window) const;
  ViewMargins margins() const;
  float overlay_scale() const;
  void choose_tool(AppContext& context);
  void handle_press(AppContext& context);
  void handle_hold(AppContext& context);
  /// The particle under the mouse in the lane that it is over, or none.
  void select_in_lane(AppContext& context) const;
  void handle_camera();
  void handle_wheel(AppContext& context, float notches);

  /// All that a picture depends on; a snapshot never changes.
  struct Shown {
    std::shared_ptr<const Snapshot> snapshot;
    RenderOptions options;
    Camera camera;
    bool operator==(const Shown&) const = default;
  };
  void follow_camera(const Snapshot& snapshot);
  /// Whether all corners are in the picture, clear of what is written over it.
  bool in_sight(const ViewBounds& bounds) const;

  struct Counted {
    std::shared_ptr<const Snapshot> snapshot;
    Field field = Field::speed;
    ColorScale scale = ColorScale::from_zero;
    ValueRange range;
    bool operator==(const Counted&) const = default;
  };
  Counted counted_;
  std::vector<float> counts_;
  ColorBarControl color_bar_;

  Renderer renderer_;
  std::optional<OffscreenTarget> target_;
  std::optional<Shown> shown_;
  Clock::time_point changed_at_{};  ///< when what is shown last changed
  Camera camera_ = Camera2D{};
  std::vector<std::unique_ptr<Tool>> tools_;
  std::size_t tool_ = 0;
  Rect where_;
  std::optional<ViewMargins> margins_;
  float pixels_per_unit_ = 1;
  float framebuffer_height_ = 0;
  ViewSize size_;
  bool fit_wanted_ = true;
  bool follow_size_ = true;  ///< the camera is still the fitted one
  ViewBounds fitted_;        ///< what it was fitted to
  double fitted_size_ = 1;   ///< their largest extent at first
  int dimension_ = 0;        ///< of the snapshot that the camera is for
  enum class Drag { none, tool, pan, orbit } drag_ = Drag::none;
  bool held_ = false;  ///< the tool has the mouse
  Point2 pressed_at_;
  bool moved_ = false;  ///< further than a click may
};

}  // namespace pf::app
