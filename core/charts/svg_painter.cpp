#include "core/charts/svg_painter.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "core/charts/font.hpp"

namespace pf {
namespace {

/// At most two decimals, no trailing zeros: a hundredth of a pixel is beyond sight.
std::string number(float value) {
  if (!std::isfinite(value)) return "0";
  std::array<char, 64> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.2f", static_cast<double>(value));
  std::string text = buffer.data();
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string out;
  for (const std::string_view part : parts) out += part;
  return out;
}

std::string attribute(std::string_view name, float value) {
  return joined({" ", name, "=\"", number(value), "\""});
}

/// fill="#rrggbb", with fill-opacity where needed.
std::string paint(std::string_view name, Color color) {
  const auto byte = [](float v) { return static_cast<int>(std::lround(255 * std::clamp(v, 0.0f, 1.0f))); };
  std::array<char, 16> hex;
  std::snprintf(hex.data(), hex.size(), "#%02x%02x%02x", byte(color.r), byte(color.g), byte(color.b));
  std::string out = joined({" ", name, "=\"", hex.data(), "\""});
  if (color.a < 1) out += attribute(joined({name, "-opacity"}), color.a);
  return out;
}

std::string box(Point2 min, Point2 max) {
  return joined({attribute("x", min.x), attribute("y", min.y), attribute("width", std::max(0.0f, max.x - min.x)),
                 attribute("height", std::max(0.0f, max.y - min.y))});
}

std::string points_attribute(std::span<const Point2> points) {
  std::string out = " points=\"";
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k > 0) out += ' ';
    out += joined({number(points[k].x), ",", number(points[k].y)});
  }
  out += '"';
  return out;
}

void append_utf8(std::string& out, char32_t c) {
  const auto byte = [&](char32_t b) { out += static_cast<char>(static_cast<unsigned char>(b)); };
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xC0 | c >> 6), byte(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    byte(0xE0 | c >> 12), byte(0x80 | (c >> 6 & 0x3F)), byte(0x80 | (c & 0x3F));
  } else {
    byte(0xF0 | c >> 18), byte(0x80 | (c >> 12 & 0x3F)), byte(0x80 | (c >> 6 & 0x3F)), byte(0x80 | (c & 0x3F));
  }
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char32_t c : decode_utf8(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default: {
        const bool forbidden = (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0xFFFE || c == 0xFFFF;
        append_utf8(out, forbidden ? 0xFFFD : c);
      }
    }
  }
  return out;
}

SvgPainter::SvgPainter(float width, float height) : width_(width), height_(height) {}

void SvgPainter::polyline(std::span<const Point2> points, Color color, float width, float dash) {
  body_ += joined({"<polyline", points_attribute(points), paint("stroke", color)});
  if (width != 1) body_ += attribute("stroke-width", width);
  if (dash > 0) body_ += attribute("stroke-dasharray", dash);
  body_ += "/>\n";
}

void SvgPainter::polygon(std::span<const Point2> points, Color fill) {
  body_ += joined({"<polygon", points_attribute(points), paint("fill", fill), "/>\n"});
}

void SvgPainter::rectangle(Point2 min, Point2 max, Color fill, float rounding) {
  body_ += joined({"<rect", box(min, max)});
  if (rounding > 0) body_ += attribute("rx", rounding);
  body_ += joined({paint("fill", fill), "/>\n"});
}

void SvgPainter::circle(Point2 centre, float radius, Color fill) {
  body_ += joined({"<circle", attribute("cx", centre.x), attribute("cy", centre.y), attribute("r", radius),
                   paint("fill", fill), "/>\n"});
}

void SvgPainter::ring(Point2 centre, float radius, Color color, float width) {
  body_ += joined({"<circle", attribute("cx", centre.x), attribute("cy", centre.y), attribute("r", radius),
                   paint("stroke", color), attribute("stroke-width", width), "/>\n"});
}

void SvgPainter::text(Point2 at, std::string_view text, float size, Color color, TextAlign align, FontWeight weight,
                      int quarter_turns) {
  body_ +=
      joined({"<text", attribute("x", at.x), attribute("y", at.y), attribute("font-size", size), paint("fill", color)});
  if (align != TextAlign::left) {
    body_ += align == TextAlign::centre ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
  }
  if (weight == FontWeight::bold) body_ += " font-weight=\"bold\"";
  if (quarter_turns % 4 != 0) {
    const std::string degrees = std::to_string(-90 * (quarter_turns % 4));
    body_ += joined({" transform=\"rotate(", degrees, " ", number(at.x), " ", number(at.y), ")\""});
  }
  body_ += joined({">", xml_escaped(text), "</text>\n"});
}

float SvgPainter::text_width(std::string_view text, float size, FontWeight weight) const {
  return shipped_font(weight).width(text, size);
}

void SvgPainter::push_clip(Point2 min, Point2 max) {
  const std::string id = joined({"clip", std::to_string(++clips_)});
  body_ +=
      joined({"<clipPath id=\"", id, "\"><rect", box(min, max), "/></clipPath>\n<g clip-path=\"url(#", id, ")\">\n"});
  ++open_;
}

void SvgPainter::pop_clip() {
  assert(open_ > 0);
  --open_;
  body_ += "</g>\n";
}

std::string SvgPainter::document(std::string_view title,
                                 const std::vector<std::pair<std::string, std::string>>& notes) const {
  assert(open_ == 0);
  std::string out =
      joined({"<svg xmlns=\"http://www.w3.org/2000/svg\"", attribute("width", width_), attribute("height", height_),
              " viewBox=\"0 0 ", number(width_), " ", number(height_), "\">\n"});
  if (!title.empty()) out += joined({"<title>", xml_escaped(title), "</title>\n"});
  if (!notes.empty()) {
    out += "<metadata>";
    for (const auto& [name, text] : notes) out += joined({xml_escaped(name), ": ", xml_escaped(text), "\n"});
    out += "</metadata>\n";
  }
  // Shapes name their own fill; what is only stroked inherits none.
  out +=
      "<g fill=\"none\" stroke-linejoin=\"round\" xml:space=\"preserve\" "
      "font-family=\"'Noto Sans','Noto Sans Math','DejaVu Sans',Arial,sans-serif\">\n";
  out += body_;
  out += "</g>\n</svg>\n";
  return out;
}

}  // namespace pf
