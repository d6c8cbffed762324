// One description of a setting serves the file, the command line, the schema, the docs and the widgets.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pf {

enum class SettingKind { number, integer, text, flag, choice, vector, formula, formula_vector, flag_vector };
/// When an edit takes effect: at the next step, or only after a reset to t = 0; `view` touches no physics.
enum class Applies { live, reset, view };

struct Setting {
  std::string pointer;  ///< pattern, "*" for an array index or a name: "/materials/*/young"
  std::string label;    ///< plain name for the interface: "Time step"
  SettingKind kind = SettingKind::number;
  std::string unit;  ///< SI, "" when dimensionless
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  bool open_min = false, open_max = false;  ///< the end itself is not allowed
  bool logarithmic = false;                 ///< a slider should be logarithmic
  double slider_min = 0, slider_max = 1;    ///< what a slider spans; typing may go further, up to min and max
  std::vector<std::string> choices;         ///< for choice
  Applies applies = Applies::live;
  bool required = false;      ///< there is no default
  std::string default_value;  ///< JSON text of the default in 2D; "" when required or absent by default
  std::string help;           ///< one or two sentences: meaning, when to change it
};

/// Every setting of the scene file, in file order.
std::span<const Setting> settings();
/// The setting that a concrete pointer ("/materials/rubber/young") names, or nullptr. A pointer to a component
/// ("/gravity/1") names the whole vector; one into a boolean shape names the setting of its outermost shape.
const Setting* find_setting(std::string_view pointer);
/// The text of docs/parameters.md: every setting with its unit, range, default and meaning.
std::string settings_markdown();

}  // namespace pf
