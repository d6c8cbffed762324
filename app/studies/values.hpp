// The values that a setting takes in a study: proposed, typed and shown. No drawing.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/params/setting.hpp"

namespace pf::app {

/// `count` numbers from `low` to `high`, both included: even in the logarithm where `logarithmic` (then both are
/// positive), rounded to three digits between the ends.
std::vector<double> ladder(double low, double high, int count, bool logarithmic);

/// Values worth comparing around `now`: every choice, on and off, a ladder of numbers within the setting's range.
std::vector<nlohmann::json> proposed_values(const Setting& setting, const nlohmann::json& now);

/// "16 ms, 8 ms, 4 ms".
std::string values_text(const std::vector<nlohmann::json>& values, const Setting& setting);
/// Numbers separated by commas, with or without units. What reads like one of `before` keeps all of its digits. When
/// something is wrong `refusal` says what, and `before` is returned.
std::vector<nlohmann::json> typed_values(std::string_view typed, const Setting& setting,
                                         const std::vector<nlohmann::json>& before, std::string& refusal);

/// One more value beyond the least (`smaller`) or the greatest, in the ladder's own ratio; `values` as they were where
/// the setting's range ends there.
std::vector<nlohmann::json> extended(const std::vector<nlohmann::json>& values, const Setting& setting, bool smaller);

}  // namespace pf::app
