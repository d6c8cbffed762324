// Where the window has written something, as a hand on the mouse finds it.
#pragma once

#include <optional>
#include <string>

#include "tests/app/hand.hpp"
#include "tests/panels/letters.hpp"

namespace pf::app::staged {

/// The middle of the `nth` place where the newest frame says `words`; spaces do not count.
inline std::optional<Point2> find_text(const std::string& words, std::size_t nth = 0) {
  std::string wanted, all;
  for (const char c : words)
    if (c != ' ') wanted += c;
  const std::vector<Letter> found = letters(*ImGui::GetDrawData());
  for (const Letter& letter : found) all += letter.code < 128 ? static_cast<char>(letter.code) : '?';
  std::size_t at = all.find(wanted);
  for (; nth > 0 && at != std::string::npos; --nth) at = all.find(wanted, at + 1);
  if (at == std::string::npos) return std::nullopt;
  const Letter &first = found[at], &last = found[at + wanted.size() - 1];
  return Point2{(first.min.x + last.max.x) / 2, (first.min.y + first.max.y) / 2};
}

inline void click_text(Stage& stage, const std::string& words, std::size_t nth = 0) {
  const auto where = find_text(words, nth);
  INFO(words);
  REQUIRE(where);
  Hand(stage).click(*where);
}

/// The same once it is to be seen.
inline void click_when_shown(Stage& stage, const std::string& words) {
  INFO(words);
  REQUIRE(stage.until([&] { return find_text(words).has_value(); }));
  click_text(stage, words);
}

/// In the bar at the top: panels may have the same name.
inline void click_menu(Stage& stage, const std::string& words) {
  const float bar = stage->layout().menu.bottom();
  for (std::size_t nth = 0; const auto where = find_text(words, nth); ++nth)
    if (where->y < bar) return Hand(stage).click(*where);
  FAIL("no menu " << words);
}

}  // namespace pf::app::staged
