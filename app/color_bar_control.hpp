// The mouse on the colour bar: drag its scale, double click for the automatic range, right click for more.
#pragma once

#include "app/context.hpp"
#include "render/overlay.hpp"

struct ImDrawList;

namespace pf::app {

class ColorBarControl {
 public:
  /// Inside of ImGui's frame, after the bar was drawn with these by a painter whose unit is `scale` pixels.
  void draw(AppContext& context, const OverlayInfo& info, Point2 min, Point2 max, float scale, ImDrawList& list);
  /// The middle of the end of the largest value and of the other in the newest frame [pixels]; nothing where no bar is
  /// shown.
  std::optional<std::pair<Point2, Point2>> ends() const { return ends_; }

 private:
  struct Held {
    double position = 0;  ///< where the bar was pressed, from 0 at the least value to 1
    ValueRange range;     ///< then
  };
  std::optional<Held> held_;
  std::optional<std::pair<Point2, Point2>> ends_;
};

/// The range that puts the value which `range` has at `pressed` to `now` (both 0 to 1, upwards): the end on the other
/// half stays, or, symmetric about `centre`, the centre.
ValueRange dragged(const ValueRange& range, double pressed, double now, ColorScale scale, double centre);

}  // namespace pf::app
