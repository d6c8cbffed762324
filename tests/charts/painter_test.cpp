#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/charts/draw.hpp"
#include "core/charts/font.hpp"
#include "core/charts/png_painter.hpp"
#include "core/charts/svg_painter.hpp"
#include "tests/charts/sample_charts.hpp"

using namespace pf;

namespace {

constexpr Color white{1, 1, 1, 1}, black{0, 0, 0, 1}, red{1, 0, 0, 1};

/// Sum over the picture of how dark it is, in pixels.
double ink(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) sum += 1 - image.color(x, y).g;
  }
  return sum;
}

struct Bounds {
  int x0 = 1 << 20, y0 = 1 << 20, x1 = -1, y1 = -1;
};
Bounds inked(const Image& image) {
  Bounds b;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.color(x, y).g > 0.8f) continue;
      b = {std::min(b.x0, x), std::min(b.y0, y), std::max(b.x1, x + 1), std::max(b.y1, y + 1)};
    }
  }
  return b;
}

/// Minimal well-formedness: tags nest, attributes are quoted, no stray markup.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = 0; at < xml.size();) {
    if (xml[at] != '<') {
      if (xml[at] == '>') return false;
      if (xml[at] == '&') {
        const std::size_t end = xml.find(';', at);
        const std::string entity = xml.substr(at, end - at + 1);
        if (entity != "&amp;" && entity != "&lt;" && entity != "&gt;" && entity != "&quot;") return false;
      }
      ++at;
      continue;
    }
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos || std::ranges::count(tag, '"') % 2 != 0) return false;
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
    at = end + 1;
  }
  return open.empty();
}

}  // namespace

TEST_CASE("filled shapes cover their exact area, wherever they lie between pixels") {
  for (const float shift : {0.0f, 0.25f, 0.7f}) {
    const auto area = [&](auto&& paint) {
      Image image(60, 60, white);
      PngPainter painter(image);
      paint(painter);
      return ink(image);
    };
    const Point2 triangle[] = {{5 + shift, 8}, {45, 20 + shift}, {15, 50}};
    const auto cross = [&](int a, int b, int c) {
      return (triangle[b].x - triangle[a].x) * (triangle[c].y - triangle[a].y) -
             (triangle[b].y - triangle[a].y) * (triangle[c].x - triangle[a].x);
    };
    CHECK(area([&](Painter& p) { p.polygon(triangle, black); }) ==
          doctest::Approx(0.5 * std::abs(cross(0, 1, 2))).epsilon(0.01));
    const Point2 arrow[] = {{10 + shift, 10}, {40, 25}, {10 + shift, 40}, {20, 25 + shift}};  // concave
    double twice = 0;
    for (int k = 0; k < 4; ++k) twice += arrow[k].x * arrow[(k + 1) % 4].y - arrow[(k + 1) % 4].x * arrow[k].y;
    CHECK(area([&](Painter& p) { p.polygon(arrow, black); }) == doctest::Approx(0.5 * std::abs(twice)).epsilon(0.01));
    CHECK(area([&](Painter& p) {
            p.rectangle({7 + shift, 9}, {30, 21 + shift}, black);
          }) == doctest::Approx((23 - shift) * (12 + shift)).epsilon(0.01));
    CHECK(area([&](Painter& p) {
            p.circle({30 + shift, 30}, 12, black);
          }) == doctest::Approx(144 * 3.14159).epsilon(0.02));
    CHECK(area([&](Painter& p) {
            p.ring({30 + shift, 30}, 12, black, 3);
          }) == doctest::Approx(2 * 3.14159 * 12 * 3).epsilon(0.02));
    const Point2 line[] = {{10, 10 + shift}, {50, 40}};
    const double length = std::hypot(40.0, 30.0 - shift);
    CHECK(area([&](Painter& p) { p.polyline(line, black, 3); }) == doctest::Approx(3 * length + 7.07).epsilon(0.03));
    CHECK(area([&](Painter& p) { p.polyline(line, black, 2, 5); }) == doctest::Approx(length).epsilon(0.2));
  }
}

TEST_CASE("pixels where expected: crisp lines, no double blending, clipping, blending") {
  Image image(20, 20, white);
  PngPainter painter(image);
  const Point2 bent[] = {{2, 4.5f}, {17, 4.5f}, {17, 18}};
  painter.polyline(bent, {0, 0, 0, 0.5f}, 1);
  for (int x = 3; x < 16; ++x) {
    CHECK(image.at(x, 4)[0] == doctest::Approx(128).epsilon(0.01));
    CHECK(image.at(x, 3)[0] == 255);
    CHECK(image.at(x, 5)[0] == 255);
  }
  painter.push_clip({5, 10}, {15, 15});
  painter.push_clip({0, 12}, {12, 20});
  painter.rectangle({0, 0}, {20, 20}, red);
  painter.pop_clip();
  painter.pop_clip();
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 16; ++x) {
      const bool inside = x >= 5 && x < 12 && y >= 12 && y < 15;
      CHECK((image.at(x, y)[1] == 0) == inside);
    }
  }
  Image clear(4, 4);
  PngPainter(clear).rectangle({0, 0}, {4, 4}, {1, 0, 0, 0.5f});
  CHECK(clear.at(1, 1)[0] == 255);  // straight alpha: full colour, half opaque
  CHECK(clear.at(1, 1)[3] == 128);
}

TEST_CASE("coordinates that are not finite or far outside do no harm") {
  Image image(20, 20, white);
  PngPainter painter(image);
  const float nan = std::nanf(""), inf = INFINITY;
  const Point2 odd[] = {{nan, 3}, {4, inf}, {1e30f, -1e30f}, {-1e9f, 10}, {1e9f, 10}};
  painter.polyline(odd, black, 2);
  painter.polyline(odd, black, 2, 3);
  painter.polygon(odd, black);
  painter.rectangle({nan, 0}, {inf, 3}, black);
  painter.circle({nan, 3}, 4, black);
  painter.text({nan, 3}, "x", 12, black);
  painter.text({1e20f, 3}, "x", 12, black);
  CHECK(image.width == 20);
  CHECK(image.at(10, 2)[0] == 255);
}

TEST_CASE("text is as wide as it is said to be, at every alignment, turn and scale") {
  const std::string text = "Hamburgefonstiv 10⁻³ ∂Ω∇φ";
  for (const auto weight : {FontWeight::regular, FontWeight::bold}) {
    for (const float scale : {1.0f, 2.0f}) {
      Image image(500 * static_cast<int>(scale), 500 * static_cast<int>(scale), white);
      PngPainter painter(image, scale);
      const float width = painter.text_width(text, 20, weight);
      CHECK(width > 150);
      painter.text({480, 250}, text, 20, black, TextAlign::right, weight);
      const Bounds level = inked(image);
      CHECK(std::abs(static_cast<float>(level.x1) / scale - 480) < 3);
      CHECK(std::abs(static_cast<float>(level.x0) / scale - (480 - width)) < 3);
      CHECK(static_cast<float>(level.y0) / scale >= 250 - 20 * 0.86f);
      CHECK(static_cast<float>(level.y1) / scale < 250 + 20 * 0.3f);
      Image turned(image.width, image.height, white);
      PngPainter(turned, scale).text({250, 250}, text, 20, black, TextAlign::centre, weight, 1);
      const Bounds upright = inked(turned);  // reads upwards, left of the baseline
      CHECK(std::abs(static_cast<float>(upright.y1) / scale - (250 + 0.5f * width)) < 3);
      CHECK(std::abs(static_cast<float>(upright.y0) / scale - (250 - 0.5f * width)) < 3);
      CHECK(static_cast<float>(upright.x0) / scale >= 250 - 20 * 0.86f);
    }
  }
}

TEST_CASE("kerning counts, and both painters measure the same") {
  const Font& font = shipped_font(FontWeight::regular);
  CHECK(font.width("AVAVAV", 20) < font.width("AAA", 20) + font.width("VVV", 20) - 2);
  Image image(1, 1);
  CHECK(PngPainter(image).text_width("Energy [kJ]", 13) == SvgPainter(10, 10).text_width("Energy [kJ]", 13));
  CHECK(font.width("", 13) == 0);
}

TEST_CASE("the shipped fonts have every character that charts and the interface write") {
  for (const char32_t c : decode_utf8("−×⁰¹²³⁴⁵⁶⁷⁸⁹⁻µ…·°±≤≥≈∞√∂∇Σ∑∫∈→←↑↓ΔΩαβγδεζηθκλμνπρστφχψω½‖⊗′")) {
    CAPTURE(static_cast<unsigned>(c));
    CHECK(shipped_font(FontWeight::regular).has(c));
    CHECK(shipped_font(FontWeight::bold).has(c));
  }
}

TEST_CASE("UTF-8 is decoded, and what is malformed becomes one replacement character") {
  CHECK(decode_utf8("aé∇𝑥") == std::vector<char32_t>{U'a', U'é', U'∇', U'𝑥'});
  CHECK(decode_utf8("\xff"
                    "a")
            .at(0) == 0xFFFD);
  CHECK(decode_utf8("\xe2\x88") == std::vector<char32_t>{0xFFFD});
  CHECK(decode_utf8("\xc0\x80").at(0) == 0xFFFD);      // overlong
  CHECK(decode_utf8("\xed\xa0\x80").at(0) == 0xFFFD);  // surrogate
}

TEST_CASE("SVG is well formed whatever the texts hold, and its text stays text") {
  for (const Chart& original : {test::energy_chart(), test::work_precision_chart(), test::stability_chart()}) {
    Chart chart = original;
    chart.title = "a < b & \"c\" > 'd' \x01 \xff";
    chart.series[0].label = "</text><script>";
    SvgPainter painter(640, 400);
    draw(chart, light_theme(), {0, 0}, {640, 400}, painter);
    const std::string svg = painter.document(chart.title, {{"Scene hash", "<&>"}});
    CHECK(well_formed(svg));
    CHECK(svg.find("<script") == std::string::npos);
    CHECK(svg.find("a &lt; b &amp; &quot;c&quot;") != std::string::npos);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.size() < 150000);
  }
  CHECK_FALSE(well_formed("<a><b></a></b>"));
  CHECK_FALSE(well_formed("<a>&nbsp;</a>"));
}

TEST_CASE("themes: text and curves show on their surface") {
  for (const ChartTheme& theme : {light_theme(), dark_theme()}) {
    CHECK(contrast_ratio(theme.text, theme.surface) >= 7);
    CHECK(contrast_ratio(theme.muted, theme.surface) >= 4.5);
    CHECK(contrast_ratio(theme.pinned, theme.surface) >= 3);
    for (const Color& color : theme.series) CHECK(contrast_ratio(color, theme.surface) >= 3);
  }
}

TEST_CASE("a chart's PNG has the curve's colour where the curve is") {
  Chart chart;
  chart.legend = LegendPlace::none;
  chart.series.push_back({.x = {0, 1, 2}, .y = {0, 3, 1}});
  const ChartTheme theme = light_theme();
  Image image(400, 300, theme.surface);
  PngPainter painter(image);
  const ChartLayout layout = draw(chart, theme, {0, 0}, {400, 300}, painter);
  for (const double x : {0.25, 0.5, 0.75, 1.4}) {
    const double y = x < 1 ? 3 * x : 3 - 2 * (x - 1);
    const int px = static_cast<int>(layout.x.map.place(x)), py = static_cast<int>(layout.y.map.place(y));
    float nearest = 9;
    for (int dy = -1; dy <= 1; ++dy) {
      const Color c = image.color(px, py + dy);
      nearest = std::min(nearest, std::abs(c.r - theme.series[0].r) + std::abs(c.g - theme.series[0].g) +
                                      std::abs(c.b - theme.series[0].b));
    }
    CHECK(nearest < 0.05f);
  }
}
