// What is written on a picture: title, clock, colour bar, scale bar, axes, length of the arrows. Painted with the
// abstract Painter, so that the window and picture files show the same.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/charts/painter.hpp"
#include "render/renderer.hpp"

namespace pf {

struct OverlayInfo {
  std::string title;
  double time = 0;  ///< [s]
  double dt = 0;    ///< [s]: decides how many decimals the clock shows; 0: unknown
  long step = -1;   ///< negative: not shown
  Field field = Field::speed;
  std::string field_label;                  ///< where its values mean something else here; empty: the field's own
  ValueRange range;                         ///< Renderer::range()
  std::vector<std::string> material_names;  ///< key to the categorical colours
  Camera camera;
  ViewSize size;                       ///< framebuffer pixels that `camera` was used with
  float pixel_scale = 1;               ///< framebuffer pixels a unit of the painter
  double arrow_pixels_per_speed = 0;   ///< Renderer::arrow_pixels_per_speed(); 0: no key to arrows
  double cross_pixels_per_pascal = 0;  ///< Renderer::cross_pixels_per_pascal(); 0: no key to crosses
  double force_metres_per_newton = 0;  ///< length of arrows of forces drawn over the view; 0: no key to them
  Color force_color;
  ColorScale scale = ColorScale::from_zero;
  std::vector<float> histogram;  ///< counts from the lower end of the bar to the upper; empty: none is shown
  bool color_bar = true, scale_bar = true, axes = true, clock = true;

  /// Everything that a snapshot and the renderer that drew it know.
  static OverlayInfo of(const Snapshot& snapshot, const Renderer& renderer, const RenderOptions& options,
                        const Camera& camera, ViewSize size);
};

/// "t = 0.25 s   step 50".
std::string clock_text(const OverlayInfo& info);

/// Into the rectangle from `min` to `max`, in the painter's units; nothing overlaps from 320 x 240 units on.
void draw_overlay(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max);

/// Where the colour bar itself is, in the painter's units; nothing where none is drawn.
struct BarPlace {
  Point2 min, max;              ///< of the coloured bar: its upper end is the largest value
  Point2 panel_min, panel_max;  ///< with all that is written beside it
  bool lies = false;            ///< the largest value is at the right, not above
};
std::optional<BarPlace> color_bar_place(const OverlayInfo& info, Painter& painter, Point2 min, Point2 max);

/// In a low or narrow view the legend of the colours lies at the bottom: a high one would stand before the content. Not
/// in one that is lower than this: there nothing but the legend would be left.
constexpr float lowest_with_lying_legend = 200;
bool legend_lies(Point2 min, Point2 max);

/// Room that the overlay needs around the content of a view of this size [units of the painter]: margins for Camera's
/// fit.
ViewMargins overlay_margins(int dimension, double width, double height);

/// A round length (1, 2 or 5 times a power of ten) of at most `most` metres, and its text: {0.05, "5 cm"}.
struct RoundLength {
  double metres = 0;
  std::string text;
};
RoundLength round_length(double most);

}  // namespace pf
