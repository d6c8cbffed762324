#include "tests/charts/sample_charts.hpp"

#include <array>
#include <cmath>

namespace pf::test {

Chart energy_chart() {
  Chart chart;
  chart.title = "Energy of a falling block";
  chart.subtitle = "FLIP 0.95, backward Euler, dt 2 ms; grey: PIC";
  chart.x = {.title = "Time", .unit = "s"};
  chart.y = {.title = "Energy", .unit = "J", .include_zero = true};
  for (const bool pinned : {true, false}) {
    Series kinetic{.label = pinned ? "Kinetic, PIC" : "Kinetic", .dashed = pinned, .pinned = pinned},
        elastic{.label = "Elastic"}, potential{.label = "Potential"}, total{.label = "Total"};
    for (int k = 0; k <= 1000; ++k) {
      const double t = 0.002 * k, damping = std::exp(-(pinned ? 1.8 : 0.25) * t), phase = std::fmod(t, 0.62) / 0.62;
      const double height = 4 * phase * (1 - phase) * damping,
                   squeeze = std::exp(-std::pow((phase - 1) / 0.06, 2)) + std::exp(-std::pow(phase / 0.06, 2));
      const double e = 30000 * damping, elastic_part = 0.8 * e * squeeze;
      kinetic.x.push_back(t), kinetic.y.push_back(std::max(0.0, e * (1 - height / damping) - elastic_part));
      elastic.x.push_back(t), elastic.y.push_back(elastic_part);
      potential.x.push_back(t), potential.y.push_back(e * height / damping);
      total.x.push_back(t), total.y.push_back(kinetic.y.back() + elastic.y.back() + potential.y.back());
    }
    chart.series.push_back(kinetic);
    if (!pinned) chart.series.insert(chart.series.end(), {elastic, potential, total});
  }
  chart.references.push_back({.at = 1.24, .vertical = true, .label = "second bounce"});
  return chart;
}

Chart work_precision_chart() {
  Chart chart;
  chart.title = "What an accurate answer costs";
  chart.subtitle = "vibrating bar, error at t = 1 s against the exact motion";
  chart.x = {.title = "Wall time", .unit = "s", .scale = AxisScale::logarithmic};
  chart.y = {.title = "Error in position (L²)", .unit = "m", .scale = AxisScale::logarithmic};
  constexpr std::array names = {"Backward Euler", "Implicit midpoint", "TR-BDF2", "Symplectic Euler"};
  constexpr std::array shapes = {MarkShape::circle, MarkShape::square, MarkShape::diamond, MarkShape::triangle};
  for (std::size_t m = 0; m < names.size(); ++m) {
    Series series{.label = names[m], .style = SeriesStyle::line_and_points, .mark = shapes[m]};
    const double order = m == 0 || m == 3 ? 1 : 2;
    for (int k = 0; k < 7; ++k) {
      const double dt = 0.02 * std::pow(0.5, k), wobble = 1 + 0.15 * std::sin(3.0 * k + static_cast<double>(m));
      const double cost = (m == 3 ? 0.004 : 0.02 + 0.008 * static_cast<double>(m)) * 1 / dt * wobble;
      const double error = (order > 1 ? 3.0 : 0.12) * std::pow(dt, order) * (m == 2 ? 0.4 : 1) + 3e-6;
      if (m == 3 && k < 3) continue;
      series.x.push_back(cost);
      series.y.push_back(error);
      series.x_low.push_back(0.85 * cost), series.x_high.push_back(1.2 * cost);
    }
    chart.series.push_back(series);
  }
  chart.triangles = {{.slope = -1}, {.slope = -2}};
  chart.references.push_back({.at = 3e-6, .label = "spatial error, dx 1/64 m"});
  chart.mark_pareto = true;
  return chart;
}

Chart convergence_chart() {
  Chart chart;
  chart.title = "Newton’s convergence";
  chart.subtitle = "twisted bar, step 212: exact tangent against projected";
  chart.x = {.title = "Iteration"};
  chart.y = {.title = "Relative residual", .scale = AxisScale::logarithmic};
  Series exact{.label = "Exact tangent", .style = SeriesStyle::line_and_points},
      projected{.label = "Projected", .style = SeriesStyle::line_and_points, .mark = MarkShape::square};
  double r = 0.8;
  for (int k = 0; k < 8; ++k) {
    exact.x.push_back(k), exact.y.push_back(r > 1e-15 ? r : 0);
    r = k < 3 ? 0.4 * r : 5 * r * r;
  }
  for (int k = 0; k < 14; ++k) projected.x.push_back(k), projected.y.push_back(0.8 * std::pow(0.22, k));
  chart.series = {exact, projected};
  chart.references.push_back({.at = 1e-6, .label = "tolerance 10⁻⁶"});
  return chart;
}

Chart stability_chart() {
  Chart chart;
  chart.title = "Where the method holds";
  chart.subtitle = "symplectic Euler, 400 runs: time step against stiffness";
  chart.x = {.title = "Time step", .unit = "s", .scale = AxisScale::logarithmic};
  chart.y = {.title = "Young’s modulus", .unit = "Pa", .scale = AxisScale::logarithmic};
  const Color good = categorical_color(2), damped = categorical_color(5), growing = categorical_color(1),
              failed = categorical_color(3);
  for (int i = 0; i < 16; ++i) {
    for (int j = 0; j < 10; ++j) {
      const auto edge_x = [](int k) { return std::pow(10, -4.5 + 0.2 * k); };
      const auto edge_y = [](int k) { return std::pow(10, 4 + 0.3 * k); };
      const double cfl = std::sqrt(edge_y(j) / 1000) * edge_x(i) / 0.02;
      const int kind = cfl < 0.3 ? 0 : cfl < 0.55 ? 1 : cfl < 0.9 ? 2 : 3;
      chart.cells.push_back(
          {edge_x(i), edge_x(i + 1), edge_y(j), edge_y(j + 1),
           std::array{good, damped, growing, failed}[static_cast<std::size_t>(kind)],
           std::array{Hatch::none, Hatch::dotted, Hatch::rising, Hatch::crossed}[static_cast<std::size_t>(kind)], ""});
    }
  }
  chart.keys = {{"good", good, Hatch::none},
                {"damped", damped, Hatch::dotted},
                {"growing", growing, Hatch::rising},
                {"failed", failed, Hatch::crossed}};
  Series limit{.label = "c dt = dx", .color = Color{0, 0, 0, 1}};
  for (int k = 0; k <= 30; ++k)
    limit.x.push_back(0.02 * std::sqrt(1000 / std::pow(10, 4 + 0.1 * k))), limit.y.push_back(std::pow(10, 4 + 0.1 * k));
  chart.series.push_back(limit);
  return chart;
}

Chart phase_chart() {
  Chart chart;
  chart.title = "Time by phase";
  chart.x.ticks = {{0, "sort"},         {1, "transfer"},    {2, "assemble"},
                   {3, "linear solve"}, {4, "line search"}, {5, "update"}};
  chart.x.min = -0.5, chart.x.max = 5.5;
  chart.y = {.title = "Time a step", .unit = "s", .include_zero = true};
  constexpr std::array ms = {0.31, 0.92, 1.84, 4.6, 0.75, 0.43};
  for (std::size_t k = 0; k < ms.size(); ++k) {
    const double at = static_cast<double>(k);
    chart.cells.push_back({at - 0.35, at + 0.35, 0, 1e-3 * ms[k], categorical_color(0), Hatch::none, ""});
  }
  return chart;
}

Chart field_chart() {
  Chart chart;
  chart.title = "Error by spacing and time step";
  chart.x = {.title = "Time step", .unit = "s", .scale = AxisScale::logarithmic};
  chart.y = {.title = "Spacing", .unit = "m", .scale = AxisScale::logarithmic};
  chart.color_bar =
      ColorBar{.map = ColormapKind::sequential,
               .axis = {.title = "Error", .unit = "m", .scale = AxisScale::logarithmic, .min = 1e-6, .max = 1e-2}};
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 5; ++j) {
      const double dt = std::pow(2.0, -i) * 0.02, dx = std::pow(2.0, -j) * 0.1, error = dt * 0.1 + dx * dx * 0.5,
                   s = std::sqrt(2.0);
      const double t = std::log10(error / 1e-6) / 4;
      chart.cells.push_back({dt / s, dt * s, dx / s, dx * s, sample(ColormapKind::sequential, t), Hatch::none,
                             i % 2 || j % 2 ? "" : "1.2×10⁻³"});
    }
  }
  return chart;
}

}  // namespace pf::test
