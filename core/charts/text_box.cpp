// Texts as rectangles: shortened to fit, and how much room they take.
#include <algorithm>

#include "core/charts/placing.hpp"

namespace pf::placing {

std::string shortened(const std::string& text, float width, float size, FontWeight weight, const Painter& painter) {
  if (painter.text_width(text, size, weight) <= width) return text;
  std::vector<std::size_t> starts;  // of characters
  for (std::size_t k = 0; k < text.size(); ++k) {
    if ((static_cast<unsigned char>(text[k]) & 0xC0) != 0x80) starts.push_back(k);
  }
  const auto cut = [&](std::size_t characters) {
    std::string head = text.substr(0, starts[characters]);
    head.erase(head.find_last_not_of(' ') + 1);
    return head + "…";
  };
  std::size_t low = 0, high = starts.size();  // cut(low) is only known to fit once low > 0
  while (low + 1 < high) {
    const std::size_t middle = (low + high) / 2;
    (painter.text_width(cut(middle), size, weight) <= width ? low : high) = middle;
  }
  return low > 0 ? cut(low) : "";
}

PlacedText placed_text(PlacedText text, const Painter& painter) {
  const float width = painter.text_width(text.text, text.size, text.weight);
  const float before = text.align == TextAlign::left ? 0 : text.align == TextAlign::centre ? 0.5f * width : width;
  Point2 a{-before, -0.86f * text.size}, b{width - before, 0.24f * text.size};
  for (int turn = 0; turn < (text.quarter_turns % 4 + 4) % 4; ++turn) {
    a = {a.y, -a.x};
    b = {b.y, -b.x};
  }
  text.box = {{text.at.x + std::min(a.x, b.x), text.at.y + std::min(a.y, b.y)},
              {text.at.x + std::max(a.x, b.x), text.at.y + std::max(a.y, b.y)}};
  return text;
}

}  // namespace pf::placing
