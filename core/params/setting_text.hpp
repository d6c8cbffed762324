// What a setting allows, in words: for messages, tooltips and docs.
#pragma once

#include <string>

#include "core/params/setting.hpp"

namespace pf {

/// "> 0 and <= 1e6", ">= 0", "any"; without the unit.
std::string range_text(const Setting& setting);
/// "a number > 0 [s]", "one of pic, flip, apic", "2 expressions in X Y Z [m/s]", ...; `components` of a vector.
std::string allowed_text(const Setting& setting, int components);
/// Is a number within the range?
bool in_range(const Setting& setting, double value);

}  // namespace pf
