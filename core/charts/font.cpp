#include "core/charts/font.hpp"

#include <stdlib.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "core/assets.hpp"
#include "core/params/problem.hpp"

// Internal linkage: Dear ImGui, and a packaged libstb, bring their own.
#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

namespace pf {
namespace {

struct Face {
  std::vector<unsigned char> bytes;
  stbtt_fontinfo info{};
  float em = 0;  ///< pixels of one unit at 1 pixel an em

  explicit Face(const char* asset) {
    const std::filesystem::path file = asset_path(asset);
    std::ifstream in(file, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    if (bytes.empty() || !stbtt_InitFont(&info, bytes.data(), stbtt_GetFontOffsetForIndex(bytes.data(), 0))) {
      throw FileError("cannot read the font " + file.string());
    }
    em = stbtt_ScaleForMappingEmToPixels(&info, 1);
  }
};

struct Placed {
  const Face* face;
  int glyph;
  float x;  ///< at 1 pixel an em
};

Point2 between(Point2 a, Point2 b, float t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// Flattens one glyph; TrueType outlines hold lines and quadratic curves only.
void append_glyph(const Placed& placed, float size, Outlines& out) {
  stbtt_vertex* vertices = nullptr;
  const int count = stbtt_GetGlyphShape(&placed.face->info, placed.glyph, &vertices);
  const float scale = placed.face->em * size;
  const auto pixel = [&](int x, int y) {
    return Point2{placed.x * size + static_cast<float>(x) * scale, -static_cast<float>(y) * scale};
  };
  for (int k = 0; k < count; ++k) {
    const stbtt_vertex& v = vertices[k];
    const Point2 to = pixel(v.x, v.y);
    if (v.type == STBTT_vmove) out.emplace_back();
    if (v.type == STBTT_vcurve) {
      const Point2 from = out.back().back(), control = pixel(v.cx, v.cy);
      const float reach =
          std::hypot(control.x - from.x, control.y - from.y) + std::hypot(to.x - control.x, to.y - control.y);
      const int pieces = 2 + static_cast<int>(std::sqrt(reach));
      for (int j = 1; j < pieces; ++j) {
        const float t = static_cast<float>(j) / static_cast<float>(pieces);
        out.back().push_back(between(between(from, control, t), between(control, to, t), t));
      }
    }
    out.back().push_back(to);
  }
  stbtt_FreeShape(&placed.face->info, vertices);
}

}  // namespace

struct Font::Implementation {
  Face text, fallback;

  explicit Implementation(FontWeight weight)
      : text(weight == FontWeight::bold ? "fonts/NotoSans-Bold.ttf" : "fonts/NotoSans-Regular.ttf"),
        fallback("fonts/NotoSansMath-Regular.ttf") {}

  /// Glyphs with their places; `end` becomes the whole advance.
  std::vector<Placed> place(std::string_view string, float& end) const {
    std::vector<Placed> placed;
    end = 0;
    for (const char32_t c : decode_utf8(string)) {
      const Face* face = &text;
      int glyph = stbtt_FindGlyphIndex(&text.info, static_cast<int>(c));
      if (glyph == 0) {
        if (const int other = stbtt_FindGlyphIndex(&fallback.info, static_cast<int>(c))) {
          glyph = other;
          face = &fallback;
        }
      }
      if (!placed.empty() && placed.back().face == face) {
        end += face->em * static_cast<float>(stbtt_GetGlyphKernAdvance(&face->info, placed.back().glyph, glyph));
      }
      placed.push_back({face, glyph, end});
      int advance = 0, bearing = 0;
      stbtt_GetGlyphHMetrics(&face->info, glyph, &advance, &bearing);
      end += face->em * static_cast<float>(advance);
    }
    return placed;
  }
};

Font::Font(FontWeight weight) : implementation_(std::make_unique<Implementation>(weight)) {}
Font::~Font() = default;

float Font::width(std::string_view text, float size) const {
  float end = 0;
  implementation_->place(text, end);
  return end * size;
}

Outlines Font::outlines(std::string_view text, float size) const {
  float end = 0;
  Outlines out;
  for (const Placed& placed : implementation_->place(text, end)) append_glyph(placed, size, out);
  return out;
}

bool Font::has(char32_t character) const {
  return stbtt_FindGlyphIndex(&implementation_->text.info, static_cast<int>(character)) != 0 ||
         stbtt_FindGlyphIndex(&implementation_->fallback.info, static_cast<int>(character)) != 0;
}

const Font& shipped_font(FontWeight weight) {
  if (weight == FontWeight::bold) {
    static const Font bold(FontWeight::bold);
    return bold;
  }
  static const Font regular(FontWeight::regular);
  return regular;
}

std::vector<char32_t> decode_utf8(std::string_view text) {
  constexpr char32_t malformed = 0xFFFD;
  std::vector<char32_t> out;
  for (std::size_t k = 0; k < text.size();) {
    const auto first = static_cast<unsigned char>(text[k++]);
    if (first < 0x80) {
      out.push_back(first);
      continue;
    }
    const int more = first >= 0xF0 && first < 0xF5   ? 3
                     : first >= 0xE0 && first < 0xF0 ? 2
                     : first >= 0xC2 && first < 0xE0 ? 1
                                                     : 0;
    char32_t c = more ? first & (0x3Fu >> more) : malformed;
    for (int j = 0; j < more; ++j) {
      const unsigned char next = k < text.size() ? static_cast<unsigned char>(text[k]) : 0;
      if ((next & 0xC0) != 0x80) {
        c = malformed;
        break;
      }
      c = c << 6 | (next & 0x3F);
      ++k;
    }
    constexpr char32_t least[] = {0, 0x80, 0x800, 0x10000};
    const bool bad = more > 0 && (c < least[more] || (c >= 0xD800 && c < 0xE000) || c > 0x10FFFF);
    out.push_back(bad ? malformed : c);
  }
  return out;
}

}  // namespace pf
