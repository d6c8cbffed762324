// Remembers what was painted, with the shipped fonts' widths.
#pragma once

#include <string>
#include <vector>

#include "core/charts/font.hpp"
#include "core/charts/layout.hpp"

namespace pf::test {

struct RecordingPainter final : Painter {
  struct Text {
    std::string text;
    Point2 at;
  };
  std::vector<Text> texts;
  std::vector<std::vector<Point2>> lines;
  std::size_t shapes = 0;
  int clips = 0;
  float largest = 0;  ///< of all coordinates' magnitudes
  bool all_finite = true;

  void see(Point2 p) {
    all_finite = all_finite && std::isfinite(p.x) && std::isfinite(p.y);
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  void polyline(std::span<const Point2> points, Color, float, float) override {
    lines.emplace_back(points.begin(), points.end());
    for (const Point2 p : points) see(p);
  }
  void polygon(std::span<const Point2> points, Color) override {
    ++shapes;
    for (const Point2 p : points) see(p);
  }
  void rectangle(Point2 min, Point2 max, Color, float) override { ++shapes, see(min), see(max); }
  void circle(Point2 centre, float, Color) override { ++shapes, see(centre); }
  void ring(Point2 centre, float, Color, float) override { ++shapes, see(centre); }
  void text(Point2 at, std::string_view text, float, Color, TextAlign, FontWeight, int) override {
    texts.push_back({std::string(text), at});
    see(at);
  }
  float text_width(std::string_view text, float size, FontWeight weight) const override {
    return shipped_font(weight).width(text, size);
  }
  void push_clip(Point2 min, Point2 max) override { ++clips, see(min), see(max); }
  void pop_clip() override { --clips; }
};

}  // namespace pf::test
