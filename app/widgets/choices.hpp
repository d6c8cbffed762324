// Plain names and one line of meaning for the words of the scene file.
#pragma once

#include <string>
#include <string_view>

namespace pf::app {

/// "backward_euler" -> "Backward Euler (implicit)". Unknown words: underscores become spaces.
std::string choice_label(std::string_view pointer, std::string_view choice);
/// What choosing it does, and of a method what shows that it is worth it; "" when nothing is known.
std::string choice_help(std::string_view pointer, std::string_view choice);
/// Whether menus have it. A method that no study puts on a front and no lesson uses is left to scene files.
bool choice_offered(std::string_view pointer, std::string_view choice);

}  // namespace pf::app
