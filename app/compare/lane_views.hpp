// The lanes of a comparison side by side, through one camera and with one colour range.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/compare/desk.hpp"
#include "app/gl_view.hpp"
#include "app/layout.hpp"
#include "core/charts/image.hpp"
#include "render/camera.hpp"
#include "render/color_range.hpp"
#include "render/offscreen.hpp"
#include "render/renderer.hpp"

struct ImDrawList;

namespace pf::app {

/// Equal cells that fill `view`, in rows from the upper left one, as many columns as show a picture of `aspect` (width
/// over height) largest.
std::vector<Rect> lane_cells(const Rect& view, std::size_t lanes, float aspect);

/// Room for what is written over a lane of this size, both in units of the overlay.
ViewMargins lane_margins(int dimension, Point2 size);

/// Needs a current OpenGL context from construction to destruction.
class LaneViews {
 public:
  /// The cell under the mouse, the first one where there is none; all have its size.
  Rect place(const Rect& view, std::size_t lanes, float aspect, Point2 mouse);
  const std::vector<Rect>& cells() const { return cells_; }
  /// Room for what is written over a lane, in units of the overlay.
  ViewMargins margins(int dimension, float overlay_scale) const;
  /// Into the framebuffer, before ImGui draws over it.
  void draw(const AppContext& context, const CompareDesk& desk, const Camera& camera, float pixels_per_unit,
            float framebuffer_height, float overlay_scale);
  /// Names, distances, scale, axes and colour bar.
  void draw_overlay(const AppContext& context, const CompareDesk& desk, const Camera& camera, float pixels_per_unit,
                    float overlay_scale, ImDrawList& list) const;
  /// The lanes as one picture, without panels, as `request` asks for it.
  Image picture(const AppContext& context, const CompareDesk& desk, const GlView& view, const PictureRequest& request,
                float pixels_per_unit, float overlay_scale);
  void forget();

 private:
  struct Shown {
    std::shared_ptr<const Snapshot> snapshot;
    RenderOptions options;
    Camera camera;
    bool operator==(const Shown&) const = default;
  };
  struct View {
    Renderer renderer;
    std::optional<OffscreenTarget> target;
    std::optional<Shown> shown;
  };
  RenderOptions options(const AppContext& context, const CompareDesk& desk, float pixel_scale);
  /// What a picture of lane `k` says.
  void write_over(Image& part, const AppContext& context, const CompareDesk& desk, std::size_t k,
                  const RenderOptions& options, const Camera& camera) const;

  std::vector<Rect> cells_;
  std::vector<std::unique_ptr<View>> views_;
  std::shared_ptr<const ComparisonFrame> ranged_;  ///< the frame that the range has seen
  Field ranged_field_ = Field::speed;
  ColorScale ranged_scale_ = ColorScale::from_zero;
  AutoRange range_;
};

}  // namespace pf::app
