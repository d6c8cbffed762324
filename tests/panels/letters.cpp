#include "tests/panels/letters.hpp"

#include <algorithm>

namespace pf::app {

namespace {

constexpr float slack = 1e-5F;  // of texture coordinates

/// The glyph of some font whose place in the atlas holds these texture coordinates.
const ImFontGlyph* glyph_at(ImVec2 low, ImVec2 high) {
  for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
    for (const ImFontGlyph& g : font->Glyphs)
      if (g.Visible && low.x >= g.U0 - slack && low.y >= g.V0 - slack && high.x <= g.U1 + slack &&
          high.y <= g.V1 + slack)
        return &g;
  return nullptr;
}

/// A letter is two triangles 0 1 2, 0 2 3 over an upright rectangle with a texture that is not a single texel.
void letters_of(const ImDrawList& list, const ImDrawCmd& command, std::vector<Letter>& found) {
  const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
  for (unsigned i = 0; i + 6 <= command.ElemCount; i += 3) {
    if (index[i] != index[i + 3] || index[i + 2] != index[i + 4]) continue;
    const auto at = [&](unsigned k) -> const ImDrawVert& {
      return list.VtxBuffer[static_cast<int>(index[i + k] + command.VtxOffset)];
    };
    const ImDrawVert &a = at(0), &b = at(1), &c = at(2);
    const bool upright = a.pos.y == b.pos.y && b.pos.x == c.pos.x && a.uv.y == b.uv.y && b.uv.x == c.uv.x;
    if (!upright || !(c.uv.x > a.uv.x) || !(c.uv.y > a.uv.y)) continue;
    const ImFontGlyph* glyph = glyph_at(a.uv, c.uv);
    if (glyph == nullptr) continue;
    const bool shortened = a.uv.x > glyph->U0 + slack || a.uv.y > glyph->V0 + slack || c.uv.x < glyph->U1 - slack ||
                           c.uv.y < glyph->V1 - slack;
    const ImVec4& clip = command.ClipRect;
    const bool outside = a.pos.x < clip.x - 1 || a.pos.y < clip.y - 1 || c.pos.x > clip.z + 1 || c.pos.y > clip.w + 1;
    found.push_back({a.pos, c.pos, glyph->Codepoint, shortened || outside});
    i += 3;
  }
}

std::string utf8(unsigned code) {
  std::string text;
  if (code < 0x80) return std::string(1, static_cast<char>(code));
  if (code < 0x800) {
    text += static_cast<char>(0xc0 | (code >> 6));
  } else {
    text += static_cast<char>(0xe0 | (code >> 12));
    text += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
  }
  return text + static_cast<char>(0x80 | (code & 0x3f));
}

std::string place(const Letter& l) {
  return utf8(l.code) + " at " + std::to_string(static_cast<int>(l.min.x)) + "," +
         std::to_string(static_cast<int>(l.min.y)) + "; ";
}

}  // namespace

std::vector<Letter> letters(const ImDrawData& data) {
  std::vector<Letter> found;
  for (int i = 0; i < data.CmdListsCount; ++i)
    for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer)
      if (command.UserCallback == nullptr) letters_of(*data.CmdLists[i], command, found);
  return found;
}

std::string overlaps(const std::vector<Letter>& found) {
  std::string text;
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = i + 1; j < found.size(); ++j) {
      const Letter &a = found[i], &b = found[j];
      const float w = std::min(a.max.x, b.max.x) - std::max(a.min.x, b.min.x);
      const float h = std::min(a.max.y, b.max.y) - std::max(a.min.y, b.min.y);
      // Kerned neighbours such as f and i touch; letters of different words would cover one another.
      const float size = std::max(a.max.y - a.min.y, b.max.y - b.min.y);
      if (w > 0.3F * size && h > 0.2F * size) text += utf8(a.code) + " on " + place(b);
    }
  return text;
}

std::string cut_off(const std::vector<Letter>& found) {
  std::string text;
  for (const Letter& l : found)
    if (l.cut) text += place(l);
  return text;
}

std::string reading(const std::vector<Letter>& found) {
  std::string text;
  for (const Letter& l : found) text += utf8(l.code);
  return text;
}

}  // namespace pf::app
