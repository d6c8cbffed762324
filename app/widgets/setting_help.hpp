// What a setting's widget says: tooltip, refusals, values as text. No drawing, so that it can be tested.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/params/setting.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

/// Meaning, range with unit, when an edit takes effect.
std::string help_text(const Setting& setting, bool waits_for_reset);
/// "0 to 1", "above 0 Pa", "" when anything goes.
std::string range_text(const Setting& setting);
/// Why the typed text cannot be this setting's number; empty when it can.
std::string number_refusal(std::string_view typed, const Setting& setting);
/// The first problem in one line: what was found and what is allowed.
std::string problem_text(std::span<const Problem> problems);
/// A value for a menu or a label: "100 kPa", "FLIP (increments)", "[0, -9.81]".
std::string value_text(const nlohmann::ordered_json& value, const Setting& setting);
/// An integer setting gets a whole number.
nlohmann::json number_json(double value, const Setting& setting);
/// What a text field holds: a number where it is one (units allowed), else the text.
nlohmann::json typed_component(std::string_view typed, const Setting& setting);
/// The scene file's default, where there is one of the same kind as `value`.
std::optional<nlohmann::ordered_json> default_value(const Setting& setting, const nlohmann::ordered_json& value);

}  // namespace pf::app
