#include "core/charts/layout.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/charts/draw.hpp"
#include "tests/charts/recording_painter.hpp"
#include "tests/charts/sample_charts.hpp"

using namespace pf;
using pf::test::RecordingPainter;

namespace {

std::vector<PlacedText> all_texts(const ChartLayout& layout) {
  std::vector<PlacedText> texts = layout.texts;
  for (const LegendEntry& entry : layout.legend.entries) texts.push_back(entry.text);
  return texts;
}

/// Texts neither touch one another nor leave the chart.
void check_texts(const ChartLayout& layout) {
  const std::vector<PlacedText> texts = all_texts(layout);
  const Box outer = layout.outer.grown(0.5f);
  for (std::size_t a = 0; a < texts.size(); ++a) {
    CAPTURE(texts[a].text);
    CHECK(outer.contains(texts[a].box.min));
    CHECK(outer.contains(texts[a].box.max));
    for (std::size_t b = 0; b < a; ++b) {
      CAPTURE(texts[b].text);
      CHECK_FALSE(texts[a].box.grown(-0.5f).overlaps(texts[b].box));
    }
  }
}

std::vector<Chart> samples() {
  return {test::energy_chart(),    test::work_precision_chart(), test::convergence_chart(),
          test::stability_chart(), test::phase_chart(),          test::field_chart()};
}

Chart line_chart(std::vector<double> x, std::vector<double> y) {
  Chart chart;
  chart.series.push_back({.label = "a", .x = std::move(x), .y = std::move(y)});
  return chart;
}

}  // namespace

TEST_CASE("texts never overlap or leave the chart, at any size of chart and font") {
  const RecordingPainter painter;
  for (Chart chart : samples()) {
    for (const LegendPlace place : {LegendPlace::automatic, LegendPlace::above, LegendPlace::below,
                                    LegendPlace::outside_right, LegendPlace::top_left}) {
      chart.legend = place;
      for (const float font : {11.0f, 13.0f, 26.0f}) {
        for (const float width : {160.0f, 260.0f, 333.3f, 520.0f, 720.0f, 1280.0f}) {
          for (const float height : {120.0f, 180.0f, 300.0f, 420.0f, 800.0f}) {
            if (width < 12 * font || height < 8 * font) continue;  // less is refused a promise
            CAPTURE(chart.title);
            CAPTURE(static_cast<int>(place));
            CAPTURE(font);
            CAPTURE(width);
            CAPTURE(height);
            check_texts(lay_out(chart, light_theme(font), {10, 20}, {10 + width, 20 + height}, painter));
          }
        }
      }
    }
  }
}

TEST_CASE("long titles, labels and many series are shortened, not cut") {
  const RecordingPainter painter;
  Chart chart = test::energy_chart();
  chart.title = chart.subtitle = chart.x.title = chart.y.title = std::string(300, 'W') + "ääää";
  for (int k = 0; k < 60; ++k) chart.series.push_back({.label = "a rather long label, number " + std::to_string(k)});
  for (const LegendPlace place : {LegendPlace::automatic, LegendPlace::above, LegendPlace::outside_right,
                                  LegendPlace::below, LegendPlace::bottom_left}) {
    chart.legend = place;
    const ChartLayout layout = lay_out(chart, light_theme(), {0, 0}, {600, 300}, painter);
    CAPTURE(static_cast<int>(place));
    check_texts(layout);
    CHECK(layout.plot.width() > 150);
    CHECK(layout.plot.height() > 60);
  }
}

TEST_CASE("a right axis has its own scale, labels and series") {
  const RecordingPainter painter;
  Chart chart = line_chart({0, 1, 2}, {0, 1, 4});
  chart.right = Axis{.title = "Residual", .scale = AxisScale::logarithmic};
  chart.series.push_back({.label = "b", .x = {0, 1, 2}, .y = {1, 1e-3, 1e-6}, .right_axis = true});
  const ChartLayout layout = lay_out(chart, dark_theme(), {0, 0}, {500, 300}, painter);
  check_texts(layout);
  REQUIRE(layout.right.has_value());
  CHECK(layout.y.map.max < 5);
  const double gap = layout.place(chart, {1, 1}).y - layout.place(chart, {1, 0}).y;
  CHECK(layout.place(chart, {1, 2}).y - layout.place(chart, {1, 1}).y == doctest::Approx(gap));
}

TEST_CASE("zeros, negatives and gaps on a logarithmic axis break the line and bend nothing") {
  RecordingPainter painter;
  const double nan = std::nan("");
  Chart chart = line_chart({0, 1, 2, 3, 4, 5, 6}, {1, 0.1, 0, 0.01, nan, -3, 0.001});
  chart.y.scale = AxisScale::logarithmic;
  const ChartLayout layout = lay_out(chart, light_theme(), {0, 0}, {500, 300}, painter);
  CHECK(layout.y.map.min > 1e-4);
  CHECK(layout.y.map.max < 10);
  REQUIRE(layout.series[0].lines.size() == 1);
  CHECK(layout.series[0].lines[0].size() == 2);
  CHECK(layout.series[0].marks.size() == 2);  // 0.01 and 0.001 stand alone
  draw(chart, light_theme(), layout, painter);
  CHECK(painter.all_finite);
}

TEST_CASE("nothing to show, one point, constants, monsters: still an orderly chart") {
  const double inf = std::numeric_limits<double>::infinity(), huge = std::numeric_limits<double>::max();
  const std::vector<std::vector<double>> datasets = {{},
                                                     {0},
                                                     {5},
                                                     {3, 3, 3},
                                                     {-1e-320, 1e-320},
                                                     {huge, -huge},
                                                     {inf, -inf, 1},
                                                     {-1, -2, 0},
                                                     {1e15, 1e15 + 1},
                                                     {1e-300, 1e300},
                                                     {std::nan("")}};
  for (const auto& data : datasets) {
    for (const auto scale : {AxisScale::linear, AxisScale::logarithmic}) {
      for (const auto style : {SeriesStyle::line, SeriesStyle::line_and_points}) {
        RecordingPainter painter;
        Chart chart = line_chart(data, data);
        chart.series[0].style = style;
        chart.x.scale = chart.y.scale = scale;
        chart.references.push_back({.at = 1, .label = "one"});
        chart.triangles.push_back({.slope = 2});
        chart.mark_pareto = true;
        const ChartLayout layout = draw(chart, light_theme(), {0, 0}, {400, 250}, painter);
        CAPTURE(data.size());
        CAPTURE(data.empty() ? 0 : data.front());
        CAPTURE(static_cast<int>(scale));
        check_texts(layout);
        CHECK(layout.x.map.min < layout.x.map.max);
        CHECK(painter.all_finite);
        CHECK(painter.largest < 5000);
        CHECK(painter.clips == 0);
      }
    }
  }
}

TEST_CASE("ranges: margins, zero, least span, the view's own ends") {
  const RecordingPainter painter;
  const auto vertical = [&](const Chart& chart) {
    return lay_out(chart, light_theme(), {0, 0}, {400, 300}, painter).y.map;
  };
  Chart chart = line_chart({0, 1}, {10, 20});
  CHECK(vertical(chart).min == doctest::Approx(9.5));
  CHECK(vertical(chart).max == doctest::Approx(20.5));
  chart.y.include_zero = true;
  CHECK(vertical(chart).min == 0);
  chart.y.min = 12, chart.y.max = 13;
  CHECK(vertical(chart).min == 12);
  CHECK(vertical(chart).max == 13);
  Chart flat = line_chart({0, 1}, {1, 1 + 1e-15});
  flat.y.least_span = 0.1;
  CHECK(vertical(flat).max - vertical(flat).min == doctest::Approx(0.11));
  Chart beyond = line_chart({0, 1}, {1, 2});
  beyond.y.min = 50;
  CHECK(vertical(beyond).min == 50);
  CHECK(vertical(beyond).max > 50);
}

TEST_CASE("the legend stays off the data where a corner is free, else outside the plot") {
  const RecordingPainter painter;
  std::vector<double> x, rising, falling;
  for (int k = 0; k <= 100; ++k) x.push_back(k), rising.push_back(std::pow(k, 3)), falling.push_back(-std::pow(k, 3));
  const auto legend = [&](const Chart& chart) {
    const ChartLayout layout = lay_out(chart, light_theme(), {0, 0}, {500, 300}, painter);
    for (const PlacedSeries& series : layout.series) {
      for (const auto& line : series.lines) {
        for (const Point2 p : line) CHECK_FALSE(layout.legend.box.contains(p));
      }
    }
    return layout;
  };
  const ChartLayout up = legend(line_chart(x, rising)), down = legend(line_chart(x, falling));
  CHECK(up.legend.covers_plot);
  CHECK(up.legend.box.centre().x < up.plot.centre().x);  // top left
  CHECK(up.legend.box.centre().y < up.plot.centre().y);
  CHECK(down.legend.box.centre().x > down.plot.centre().x);  // top right
  Chart full = line_chart({}, {});
  for (int k = 0; k < 4000; ++k) {
    full.series[0].x.push_back(k);
    full.series[0].y.push_back(k % 2);
  }
  CHECK_FALSE(legend(full).legend.covers_plot);
  full.legend = LegendPlace::none;
  CHECK(legend(full).legend.entries.empty());
}

TEST_CASE("a long series is thinned to the plot's columns and keeps its extremes") {
  const RecordingPainter painter;
  Chart chart = line_chart({}, {});
  for (int k = 0; k < 200000; ++k) {
    chart.series[0].x.push_back(k);
    chart.series[0].y.push_back(k == 123457 ? 9.0 : std::sin(k * 0.37));
  }
  const ChartLayout layout = lay_out(chart, light_theme(), {0, 0}, {500, 300}, painter);
  std::size_t count = 0;
  float top = 1e9f;
  for (const auto& line : layout.series[0].lines) {
    count += line.size();
    for (const Point2 p : line) top = std::min(top, p.y);
  }
  CHECK(count < 5 * 500);
  CHECK(top == doctest::Approx(layout.y.map.place(9)).epsilon(1e-4));
}

TEST_CASE("a line zoomed far in is clipped to the plot") {
  RecordingPainter painter;
  Chart chart = line_chart({0, 1}, {0, 1});
  chart.x.min = 0.5, chart.x.max = 0.5 + 1e-9;
  chart.y.min = 0.5, chart.y.max = 0.5 + 1e-9;
  const ChartLayout layout = draw(chart, light_theme(), {0, 0}, {400, 300}, painter);
  CHECK(painter.largest < 1000);
  REQUIRE(layout.series[0].lines.size() == 1);
  CHECK(layout.series[0].lines[0].front().y > layout.plot.max.y - 1);
  CHECK(layout.series[0].lines[0].back().y < layout.plot.min.y + 1);
}

TEST_CASE("slope triangles have the slope they name, and lie off the data") {
  const RecordingPainter painter;
  for (const double slope : {1.0, 2.0, -1.0, -2.0, 0.5}) {
    Chart chart = line_chart({}, {});
    chart.x.scale = chart.y.scale = AxisScale::logarithmic;
    for (int k = 0; k < 20; ++k) {
      chart.series[0].x.push_back(std::pow(10, 0.2 * k));
      chart.series[0].y.push_back(std::pow(10, 0.2 * k * slope));
    }
    chart.triangles.push_back({.slope = slope});
    const ChartLayout layout = lay_out(chart, light_theme(), {0, 0}, {700, 400}, painter);
    CAPTURE(slope);
    REQUIRE(layout.triangles.size() == 1);
    const auto& c = layout.triangles[0].corners;
    const double rise = std::log10(layout.y.map.value(c[2].y) / layout.y.map.value(c[0].y));
    const double run = std::log10(layout.x.map.value(c[2].x) / layout.x.map.value(c[0].x));
    CHECK(rise / run == doctest::Approx(slope).epsilon(1e-3));
    CHECK(run == doctest::Approx(0.5).epsilon(1e-3));
    for (const Point2 corner : c) CHECK(layout.plot.contains(corner));
    // The data has the same slope: parallel, so every corner is at a distance.
    for (const Point2 corner : c) {
      const double on_line = layout.y.map.place(std::pow(layout.x.map.value(corner.x), slope));
      CHECK(std::abs(on_line - corner.y) > 5);
    }
  }
}
