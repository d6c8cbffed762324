// The number's own controls: a thin slider, and a value that turns into a text field.
#pragma once

#include <string>
#include <string_view>

namespace pf::app {

struct SliderRange {
  double min = 0, max = 1;  ///< min < max; both positive when logarithmic
  bool logarithmic = false;
  bool integer = false;
};

/// Where `value` stands on the slider, in [0, 1], and back (rounded to digits that make sense to a hand).
double slider_position(double value, const SliderRange& range);
double slider_value(double position, const SliderRange& range);

struct SliderResult {
  bool changed = false;  ///< `value` was moved by dragging or keys
  bool type = false;     ///< Ctrl+click: let the user type
};
/// Over the available width. `mark`: a value to show as a notch (NaN: none).
SliderResult slider(const char* id, double& value, const SliderRange& range, double mark);

}  // namespace pf::app
