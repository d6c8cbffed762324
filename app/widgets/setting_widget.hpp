// One widget for every setting of the scene, made from its description in core/params/setting.hpp.
#pragma once

#include <string>
#include <string_view>

#include "app/context.hpp"

namespace pf::app {

/// How a widget differs from what the setting's description says.
struct SettingLook {
  std::string_view label = {};  ///< instead of the setting's own
  std::string_view note = {};   ///< a muted line below
  /// Turns the chosen value into edits, where one setting draws others after it; empty: the setting alone.
  std::function<std::vector<Edit>(const nlohmann::json&)> edits = {};
};

/// Draws the setting that the JSON pointer names in the scene being edited: slider, combo, check box, numbers or
/// formulae, with unit, tooltip, a mark where it needs a reset, and what was wrong with a refused value. Edits go
/// through context.change(). Draws nothing where the scene does not use the setting (scene_uses) or has none there.
/// Click on the value or Ctrl+click on the slider: type; middle click: back to the value as opened; right click:
/// menu. True when the scene was changed.
bool setting_widget(AppContext& context, const std::string& pointer, const SettingLook& look = {});

/// "/materials/" + name + "/" + key with the escapes of JSON pointers.
std::string pointer_to(std::initializer_list<std::string_view> parts);

}  // namespace pf::app
