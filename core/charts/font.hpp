// The shipped fonts: glyph outlines and widths, the same for every painter.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/charts/painter.hpp"

namespace pf {

/// Closed outlines of a text, as polygons; holes run the other way round.
using Outlines = std::vector<std::vector<Point2>>;

/// A weight of Noto Sans with Noto Sans Math for what it lacks. Immutable; may be shared by threads.
class Font {
 public:
  /// Loads the shipped files. Throws FileError.
  explicit Font(FontWeight weight);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Advance with kerning [pixels]; `size` is the em [pixels]. Bytes that are not UTF-8 count as U+FFFD.
  float width(std::string_view text, float size) const;
  /// Outlines with the baseline's left end at the origin, y downwards.
  Outlines outlines(std::string_view text, float size) const;
  /// Whether some shipped font has a glyph for the character.
  bool has(char32_t character) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The weight's font, loaded once.
const Font& shipped_font(FontWeight weight);

/// Decodes UTF-8; what is malformed becomes U+FFFD.
std::vector<char32_t> decode_utf8(std::string_view text);

}  // namespace pf
