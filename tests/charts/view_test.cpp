#include <doctest/doctest.h>

#include <cmath>

#include "core/charts/draw.hpp"
#include "tests/charts/recording_painter.hpp"
#include "tests/charts/sample_charts.hpp"

using namespace pf;
using pf::test::RecordingPainter;

namespace {

Chart small_chart(AxisScale scale = AxisScale::linear) {
  Chart chart;
  chart.x.scale = chart.y.scale = scale;
  chart.series.push_back({.label = "a", .x = {1, 2, 3, 4}, .y = {1, 4, 9, 16}});
  chart.series.push_back({.label = "b", .x = {1, 2, 3, 4}, .y = {8, 8, 8, 8}});
  return chart;
}
constexpr Point2 origin{0, 0}, size{480, 320};

}  // namespace

TEST_CASE("values and pixels are inverse on both scales") {
  for (const auto scale : {AxisScale::linear, AxisScale::logarithmic}) {
    const AxisMap map{scale, 0.01, 500, 300, 20};
    CHECK(map.place(0.01) == 300);
    CHECK(map.place(500) == doctest::Approx(20));
    for (const double v : {0.02, 1.0, 77.0, 600.0}) CHECK(map.value(map.place(v)) == doctest::Approx(v));
  }
  CHECK(std::isnan(AxisMap{AxisScale::logarithmic, 1, 10, 0, 1}.place(0)));
}

TEST_CASE("the nearest point is found by pixel, with its series, index and values") {
  const RecordingPainter painter;
  const Chart chart = small_chart();
  const ChartLayout layout = lay_out(chart, light_theme(), origin, size, painter);
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Point2 at = layout.place(chart, {s, k});
      const auto hit = hit_test(chart, layout, {std::clamp(at.x + 2, layout.plot.min.x, layout.plot.max.x), at.y - 2});
      REQUIRE(hit.has_value());
      CHECK(hit->point == PointId{s, k});
      CHECK(hit->x == chart.series[s].x[k]);
      CHECK(hit->y == chart.series[s].y[k]);
      CHECK(hit->distance < 4);
    }
  }
  const Point2 between = layout.place(chart, {0, 3});
  CHECK_FALSE(hit_test(chart, layout, {between.x - 40, between.y}).has_value());
  CHECK_FALSE(hit_test(chart, layout, {layout.plot.min.x - 3, between.y}, 1000).has_value());
}

TEST_CASE("zooming keeps the value under the mouse; panning moves with it") {
  const RecordingPainter painter;
  for (const auto scale : {AxisScale::linear, AxisScale::logarithmic}) {
    Chart chart = small_chart(scale);
    const ChartLayout before = lay_out(chart, light_theme(), origin, size, painter);
    const Point2 mouse{before.plot.min.x + 100, before.plot.min.y + 70};
    const double x = before.x.map.value(mouse.x), y = before.y.map.value(mouse.y);
    zoom(chart, before, mouse, 0.5);
    ChartLayout after = lay_out(chart, light_theme(), origin, size, painter);
    after.plot = before.plot;
    AxisMap map = after.x.map;
    map.from = before.x.map.from, map.to = before.x.map.to;
    CHECK(map.value(mouse.x) == doctest::Approx(x));
    map = after.y.map;
    map.from = before.y.map.from, map.to = before.y.map.to;
    CHECK(map.value(mouse.y) == doctest::Approx(y));

    reset_view(chart);
    pan(chart, before, {30, -20});
    CHECK(*chart.x.min == doctest::Approx(before.x.map.value(before.x.map.from - 30)));
    CHECK(*chart.y.max == doctest::Approx(before.y.map.value(before.y.map.to + 20)));
    reset_view(chart);
    CHECK_FALSE(chart.x.min.has_value());
  }
}

TEST_CASE("no amount of zooming breaks the numbers") {
  const RecordingPainter painter;
  for (const auto scale : {AxisScale::linear, AxisScale::logarithmic}) {
    for (const double factor : {0.1, 10.0}) {
      Chart chart = small_chart(scale);
      for (int k = 0; k < 400; ++k) {
        const ChartLayout layout = lay_out(chart, light_theme(), origin, size, painter);
        REQUIRE(layout.x.map.min < layout.x.map.max);
        REQUIRE(std::isfinite(layout.x.map.max));
        zoom(chart, layout, layout.plot.centre(), factor);
      }
    }
  }
}

TEST_CASE("the hover note stays inside the chart at every corner") {
  for (const Point2 extent : {Point2{480, 320}, Point2{200, 140}}) {
    Chart chart = small_chart();
    chart.series[0].label = "a label far longer than the note has room for in this chart";
    RecordingPainter painter;
    const ChartLayout layout = lay_out(chart, light_theme(), origin, extent, painter);
    for (std::size_t k = 0; k < 4; ++k) {
      RecordingPainter note;
      const Point2 at = layout.place(chart, {0, k});
      draw_hover(chart, light_theme(), layout, {{0, k}, 1, 2, at, 0}, note);
      REQUIRE(note.texts.size() == 3);
      for (const auto& text : note.texts) {
        CHECK(text.at.x > 0);
        CHECK(text.at.x + note.text_width(text.text, 13, FontWeight::regular) < extent.x + 1);
        CHECK(text.at.y > 13 * 0.7);
        CHECK(text.at.y < extent.y);
      }
    }
  }
}

TEST_CASE("the Pareto front: what no other point beats") {
  Chart chart;
  const double nan = std::nan("");
  chart.series.push_back({.x = {1, 2, 3, 4, nan, 0.1}, .y = {10, 5, 7, 1, 0, nan}, .style = SeriesStyle::points});
  chart.series.push_back({.x = {2, 5, 0.5}, .y = {5, 0.5, 20}, .style = SeriesStyle::points});
  chart.series.push_back({.x = {0.01}, .y = {0.01}, .pinned = true});
  const std::vector<PointId> expected = {{1, 2}, {0, 0}, {0, 1}, {1, 0}, {0, 3}, {1, 1}};
  CHECK(pareto_front(chart) == expected);
  chart.series[0].y[3] = -1;
  CHECK(pareto_front(chart).back() == PointId{0, 3});
  chart.y.scale = AxisScale::logarithmic;
  CHECK(pareto_front(chart).back() == PointId{1, 1});
}

TEST_CASE("CSV: 17 digits, quoted labels, error bars where there are any") {
  Chart chart = small_chart();
  chart.x = {.title = "Time", .unit = "s"};
  chart.series[0].label = "a \"b\", c";
  chart.series[0].x[0] = 0.1;
  chart.series[1].y_low = {7, 7, 7, 7};
  chart.series[1].y_high = {9, 9, 9, 9};
  const std::string csv = chart_csv(chart);
  CHECK(csv.starts_with("series,Time [s],y,y_low,y_high\n\"a \"\"b\"\", c\",0.10000000000000001,1,,\n"));
  CHECK(csv.ends_with("b,4,8,7,9\n"));
}
