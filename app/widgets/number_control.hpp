// Label, value and slider of one number, for settings of the scene and of the view alike.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/params/setting.hpp"

namespace pf::app {

/// A value that is being typed, and what was wrong with the last one.
struct Typing {
  std::string key;  ///< whose text it is, a JSON pointer or a name; empty: nobody's
  std::string text;
  bool focus = false;  ///< take the keyboard in this frame
  std::string refused_key, refusal;

  void begin(const std::string& whose, double number);
  void refuse(const std::string& whose, std::string why);
  void forgive(const std::string& whose);
};

struct NumberControl {
  Typing& typing;
  const Setting& setting;  ///< unit, range, slider, help
  const std::string& key;
  std::string label, help;
  double mark;                       ///< a notch on the slider; NaN: none
  bool needs_reset = false;          ///< show the small mark behind the label
  std::function<void()> after_item;  ///< called after the value and the slider, for a context menu; may be empty
};

/// The new value when the user moved or typed one that is allowed; refusals go to `typing`.
std::optional<double> number_control(const NumberControl& control, double number);

/// The label alone, wrapped in `width`, with its tooltip and mark.
void setting_label(const std::string& label, const std::string& help, bool needs_reset, float width);

}  // namespace pf::app
