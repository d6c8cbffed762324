// The letters that ImGui drew, found again in its draw data: what a person would see of the text.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

namespace pf::app {

/// A letter as it was drawn.
struct Letter {
  ImVec2 min, max;   ///< [pixels]
  unsigned code;     ///< Unicode
  bool cut = false;  ///< a part of it is hidden by the clip rectangle
};
/// Every upright letter in the draw data.
std::vector<Letter> letters(const ImDrawData& data);
/// Pairs that lie on top of one another, as text for a message; "" when there are none.
std::string overlaps(const std::vector<Letter>& found);
/// The letters that are cut off; "" when there are none.
std::string cut_off(const std::vector<Letter>& found);
/// The letters in the order in which they were drawn, without spaces.
std::string reading(const std::vector<Letter>& found);

}  // namespace pf::app
