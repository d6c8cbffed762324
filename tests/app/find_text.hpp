// Where the window has written something, as a hand on the mouse finds it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/app/hand.hpp"
#include "tests/panels/letters.hpp"

namespace pf::app::staged {

/// Where the newest frame says it.
struct TextPlace {
  Point2 middle;
  bool whole = true;  ///< no letter is cut off or scrolled away
};

/// All places where the newest frame says `words`, in the order in which they were drawn; spaces do not count.
inline std::vector<TextPlace> places_of(const std::string& words) {
  std::string wanted, all;
  for (const char c : words)
    if (c != ' ') wanted += c;
  const std::vector<Letter> found = letters(*ImGui::GetDrawData());
  for (const Letter& letter : found) all += letter.code < 128 ? static_cast<char>(letter.code) : '?';
  std::vector<TextPlace> places;
  for (std::size_t at = all.find(wanted); at != std::string::npos; at = all.find(wanted, at + 1)) {
    const Letter &first = found[at], &last = found[at + wanted.size() - 1];
    TextPlace& place = places.emplace_back();
    place.middle = {(first.min.x + last.max.x) / 2, (first.min.y + first.max.y) / 2};
    for (std::size_t k = at; k < at + wanted.size(); ++k) place.whole = place.whole && !found[k].cut;
  }
  return places;
}

/// The middle of the `nth` of them.
inline std::optional<Point2> find_text(const std::string& words, std::size_t nth = 0) {
  const std::vector<TextPlace> places = places_of(words);
  return nth < places.size() ? std::optional(places[nth].middle) : std::nullopt;
}

/// The first one that can be read.
inline std::optional<Point2> find_whole_text(const std::string& words) {
  for (const TextPlace& place : places_of(words))
    if (place.whole) return place.middle;
  return std::nullopt;
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
