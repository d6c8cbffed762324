#include "core/charts/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/charts/ticks.hpp"

namespace pf {
namespace {

bool has_place(double value, AxisScale scale) {
  return std::isfinite(value) && (scale == AxisScale::linear || value > 0);
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  quoted += '"';
  return quoted;
}

std::string csv_number(double value) {
  std::array<char, 40> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.17g", value);
  return buffer.data();
}

std::string heading(const Axis& axis, const char* otherwise) {
  const std::string title = axis_title(axis.title, axis.unit, 0);
  return csv_field(title.empty() ? otherwise : title);
}

/// A value and its error bar; without one both ends are the value.
struct Interval {
  double value, low, high;
};
struct Candidate {
  PointId id;
  Interval x, y;
};

Candidate candidate(const Series& series, PointId id) {
  const auto interval = [&](const auto& values, const auto& low, const auto& high) {
    const double value = values[id.index];
    const bool has = id.index < low.size() && id.index < high.size();
    return Interval{value, has ? std::fmin(low[id.index], value) : value,
                    has ? std::fmax(high[id.index], value) : value};
  };
  return {id, interval(series.x, series.x_low, series.x_high), interval(series.y, series.y_low, series.y_high)};
}
/// `ties` is a share of the larger size; for values of one sign.
double slack(double a, double b, double ties) {
  return ties * std::max(std::abs(a), std::abs(b));
}
bool better(const Interval& a, const Interval& b, double ties) {
  return a.high + slack(a.high, b.low, ties) < b.low;
}
bool as_good(const Interval& a, const Interval& b, double ties) {
  return a.low <= b.high + slack(a.low, b.high, ties);
}

}  // namespace

std::vector<PointId> pareto_front(const Chart& chart) {
  std::vector<PointId> candidates;
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    const Series& series = chart.series[s];
    if (series.pinned || series.right_axis) continue;
    for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
      if (has_place(series.x[k], chart.x.scale) && has_place(series.y[k], chart.y.scale)) candidates.push_back({s, k});
    }
  }
  std::vector<Candidate> all;
  all.reserve(candidates.size());
  for (const PointId p : candidates) all.push_back(candidate(chart.series[p.series], p));
  std::ranges::stable_sort(all, [](const Candidate& a, const Candidate& b) {
    return a.x.value != b.x.value ? a.x.value < b.x.value : a.y.value < b.y.value;
  });
  const double ties = std::max(0.0, chart.pareto_ties);
  std::vector<PointId> front;
  for (const Candidate& p : all) {
    const bool beaten = std::ranges::any_of(all, [&](const Candidate& q) {
      return as_good(q.x, p.x, ties) && as_good(q.y, p.y, ties) && (better(q.x, p.x, ties) || better(q.y, p.y, ties));
    });
    if (!beaten) front.push_back(p.id);
  }
  return front;
}

std::string chart_csv(const Chart& chart) {
  const auto any = [&](auto member) {
    return std::ranges::any_of(chart.series, [&](const Series& s) { return !(s.*member).empty(); });
  };
  const bool has_x_bars = any(&Series::x_low), has_y_bars = any(&Series::y_low);
  std::string out = "series," + heading(chart.x, "x") + "," + heading(chart.y, "y");
  if (chart.right) out += "," + heading(*chart.right, "right");
  if (has_x_bars) out += ",x_low,x_high";
  if (has_y_bars) out += ",y_low,y_high";
  out += "\n";
  const auto cell = [&](const std::vector<double>& values, std::size_t k) {
    return "," + (k < values.size() ? csv_number(values[k]) : std::string());
  };
  for (const Series& series : chart.series) {
    for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
      out += csv_field(series.label) + cell(series.x, k);
      if (chart.right && series.right_axis) out += ",";
      out += cell(series.y, k);
      if (chart.right && !series.right_axis) out += ",";
      if (has_x_bars) out += cell(series.x_low, k) + cell(series.x_high, k);
      if (has_y_bars) out += cell(series.y_low, k) + cell(series.y_high, k);
      out += "\n";
    }
  }
  return out;
}

}  // namespace pf
