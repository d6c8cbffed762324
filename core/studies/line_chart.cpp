// Error against cost, error against dt, cost against grid: one line a method.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/charts/ticks.hpp"
#include "core/params/json_text.hpp"
#include "core/studies/orders.hpp"
#include "core/studies/results.hpp"
#include "core/studies/study_charts.hpp"

namespace pf {

namespace {

constexpr double ties = 0.01;  ///< errors and counted work within 1 % are the same

bool all_numbers(const StudyAxis& axis) {
  return axis.is_pointer() && std::all_of(axis.values.begin(), axis.values.end(),
                                          [](const StudyValue& v) { return v.edits.front().value.is_number(); });
}

/// What changes along a line, where the study does not say: dt, dx, or the axis of numbers with the most values.
std::string along_of(const Study& study) {
  if (!study.along.empty()) return study.along;
  const std::vector<std::string> columns = varied_columns(study);
  for (const char* usual : {"/time/step", "/grid/spacing"})
    if (std::find(columns.begin(), columns.end(), usual) != columns.end()) return usual;
  const StudyAxis* most = nullptr;
  for (const StudyAxis& axis : study.axes)
    if (all_numbers(axis) && (most == nullptr || axis.values.size() > most->values.size())) most = &axis;
  return most != nullptr ? most->key : "";
}

/// Columns whose values tell lines apart. Where override objects have labels, these stand for all that they set.
std::vector<std::string> line_columns(const Study& study, const StudyChart& spec) {
  if (!spec.lines.empty()) return {spec.lines};
  const std::string along = spec.x.starts_with('/') ? spec.x : along_of(study);
  std::vector<std::string> columns;
  for (const StudyAxis& axis : study.axes) {
    const bool labelled = !axis.is_pointer() && std::all_of(axis.values.begin(), axis.values.end(),
                                                            [](const StudyValue& v) { return !v.label.empty(); });
    const std::string key = axis.key.empty() ? "label" : axis.key;
    if (labelled && key != along &&
        !(axis.key.empty() && axis.values.size() == study_size(study) && along.starts_with('/')))
      columns.push_back(key);
    if (labelled) continue;
    for (const StudyValue& value : axis.values)
      for (const Edit& edit : value.edits)
        if (edit.pointer != along && std::find(columns.begin(), columns.end(), edit.pointer) == columns.end())
          columns.push_back(edit.pointer);
  }
  return columns;
}

struct Place {
  double value = not_measured, low = not_measured, high = not_measured;
};

/// The value of a column, and its interval where it has one.
Place place_of(const Study& study, const StudyRow& row, const std::string& column) {
  if (column == "cost" || column == "wall_s") {
    const Cost cost = cost_of(study, row);
    return {cost.value, cost.low, cost.high};
  }
  if (const RowColumn* known = find_row_column(column)) {
    const double value = row.*known->member;
    return {value, value, value};
  }
  const std::vector<std::string> columns = varied_columns(study);
  const auto values = varied_values(study, study_point(study, row.point));
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k] == column && values[k].is_number()) {
      const double value = values[k].get<double>();
      return {value, value, value};
    }
  return {};
}

bool has_interval(const Study& study, const std::string& column) {
  return study.cost == "wall" && study.repeat > 1 && (column == "cost" || column == "wall_s");
}

std::string line_label(const Study& study, const StudyRow& row, const std::vector<std::string>& lines) {
  const std::vector<std::string> columns = varied_columns(study);
  const auto values = varied_values(study, study_point(study, row.point));
  std::string label;
  for (const std::string& line : lines) {
    const auto found = std::find(columns.begin(), columns.end(), line);
    if (found == columns.end()) continue;
    const std::string text = value_label(line, values[static_cast<std::size_t>(found - columns.begin())]);
    if (!text.empty()) label += (label.empty() ? "" : ", ") + text;
  }
  return label;
}

Axis axis_of(const Study& study, const std::string& column, const std::vector<double>& values) {
  const auto [title, unit] = column_title(study, column);
  Axis axis{.title = title, .unit = unit};
  const bool positive = !values.empty() && std::all_of(values.begin(), values.end(), [](double v) { return v > 0; });
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (positive && *high > 3 * *low) axis.scale = AxisScale::logarithmic;
  if (positive && column == "cost") axis.scale = AxisScale::logarithmic;
  if (find_row_column(column) != nullptr && column.starts_with("error") && positive)
    axis.scale = AxisScale::logarithmic;
  return axis;
}

std::string subtitle_of(const Study& study, const StudyChart& spec, std::size_t left_out) {
  std::string text;
  const bool error = spec.y.starts_with("error") || spec.x.starts_with("error");
  if (error && study.reference == ReferenceKind::exact) text += "against the exact motion";
  if (error && study.reference == ReferenceKind::run) text += "against a fine run";
  if (error && study.samples > 1) text += ", rms of " + std::to_string(study.samples) + " times";
  if (has_interval(study, spec.x) || has_interval(study, spec.y))
    text += (text.empty() ? "" : "; ") + std::string("median of ") + std::to_string(study.repeat) +
            " runs, bars: least and most";
  if (left_out > 0)
    text += (text.empty() ? "" : "; ") + std::to_string(left_out) + (left_out == 1 ? " run" : " runs") +
            " failed or blew up";
  return text;
}

struct Line {
  Series series;
  std::vector<std::size_t> point;
};

Line& line_of(std::vector<Line>& lines, const std::string& label) {
  for (Line& line : lines)
    if (line.series.label == label) return line;
  constexpr MarkShape shapes[] = {MarkShape::circle, MarkShape::square, MarkShape::triangle, MarkShape::diamond};
  Line line;
  line.series.label = label;
  line.series.style = SeriesStyle::line_and_points;
  line.series.mark = shapes[lines.size() % 4];
  line.series.color_index = lines.size() % 8;
  line.series.dashed = lines.size() >= 8;
  lines.push_back(line);
  return lines.back();
}

void add_point(Line& line, const Place& x, const Place& y, bool x_bars, bool y_bars, std::size_t point) {
  line.series.x.push_back(x.value);
  line.series.y.push_back(y.value);
  if (x_bars) line.series.x_low.push_back(x.low), line.series.x_high.push_back(x.high);
  if (y_bars) line.series.y_low.push_back(y.low), line.series.y_high.push_back(y.high);
  line.point.push_back(point);
}

void name_orders(std::vector<Line>& lines) {
  for (Line& line : lines) {
    const FittedOrder fit = fit_order(line.series.x, line.series.y);
    if (fit.points >= 3)
      line.series.label += (line.series.label.empty() ? "order " : ", order ") + fixed_text(fit.order, 2);
  }
}

}  // namespace

StudyFigure line_figure(const Study& study, std::span<const StudyRow> rows, const StudyChart& spec) {
  const std::vector<std::string> columns = line_columns(study, spec);
  const bool x_bars = has_interval(study, spec.x), y_bars = has_interval(study, spec.y);
  std::vector<Line> lines;
  Line bad;
  std::vector<double> xs, ys;
  std::size_t left_out = 0;
  for (const StudyRow& row : rows) {
    const Place x = place_of(study, row, spec.x), y = place_of(study, row, spec.y);
    // A run that grew but came to its end has an error like any other; the other bad ones stopped half-way.
    if (row.behaviour == RunClass::failed || row.behaviour == RunClass::blown_up) {
      ++left_out;
      if (std::isfinite(x.value) && std::isfinite(y.value)) add_point(bad, x, y, false, false, row.point);
      continue;
    }
    if (!std::isfinite(x.value) || !std::isfinite(y.value)) continue;
    add_point(line_of(lines, line_label(study, row, columns)), x, y, x_bars, y_bars, row.point);
    xs.push_back(x.value);
    ys.push_back(y.value);
  }
  StudyFigure figure;
  figure.name = spec.name.empty() ? "chart" : spec.name;
  Chart& chart = figure.chart;
  chart.title = spec.title.empty() ? study.name : spec.title;
  chart.subtitle = spec.subtitle.empty() ? subtitle_of(study, spec, left_out) : spec.subtitle;
  chart.x = axis_of(study, spec.x, xs);
  chart.y = axis_of(study, spec.y, ys);
  if (spec.fit) name_orders(lines);
  for (Line& line : lines) {
    chart.series.push_back(std::move(line.series));
    figure.point.push_back(std::move(line.point));
  }
  // Runs that went wrong stay near the others: a run that grew a million times would make all of them one dot.
  if (!ys.empty() && !bad.point.empty()) {
    const double most = 10 * *std::max_element(ys.begin(), ys.end());
    Line near;
    for (std::size_t k = 0; k < bad.point.size(); ++k)
      if (bad.series.y[k] <= most && bad.series.y[k] > 0)
        add_point(near, {bad.series.x[k]}, {bad.series.y[k]}, false, false, bad.point[k]);
    near.series.label = "failed or blew up";
    near.series.style = SeriesStyle::points;
    near.series.mark = MarkShape::cross;
    near.series.pinned = true;
    if (!near.point.empty()) {
      chart.series.push_back(near.series);
      figure.point.push_back(near.point);
    }
  }
  // Triangles of a fifth of the width.
  const auto [least, most] = std::minmax_element(xs.begin(), xs.end());
  const double decades = xs.empty() || !(*least > 0) ? 0.5 : std::max(0.05, 0.2 * std::log10(*most / *least));
  for (const double slope : spec.slopes) chart.triangles.push_back({.slope = slope, .decades = decades});
  chart.mark_pareto = spec.pareto;
  chart.pareto_ties = ties;
  if (chart.series.size() > 5) chart.legend = LegendPlace::outside_right;
  return figure;
}

namespace {

/// Error against cost; against dt and dx where these take three values or more.
std::vector<StudyChart> usual_charts(const Study& study) {
  std::vector<StudyChart> charts{{.pareto = true}};
  for (const auto& [pointer, name] : {std::pair("/time/step", "dt"), std::pair("/grid/spacing", "dx")})
    for (const StudyAxis& axis : study.axes)
      if (axis.key == pointer && axis.values.size() >= 3)
        charts.push_back({.name = std::string("chart-") + name, .x = pointer, .fit = true, .slopes = {1, 2}});
  return charts;
}

}  // namespace

std::vector<StudyFigure> study_figures(const Study& study, std::span<const StudyRow> rows) {
  if (study.kind == StudyKind::stability_map) {
    std::vector<StudyFigure> figures = map_figures(study, rows);
    for (const StudyChart& spec : study.charts) figures.push_back(line_figure(study, rows, spec));
    return figures;
  }
  const std::vector<StudyChart> charts = study.charts.empty() ? usual_charts(study) : study.charts;
  std::vector<StudyFigure> figures;
  for (std::size_t k = 0; k < charts.size(); ++k) {
    StudyChart spec = charts[k];
    if (k == 0) spec.name = "";
    if (k > 0 && spec.name.empty()) spec.name = "chart-" + std::to_string(k + 1);
    figures.push_back(line_figure(study, rows, spec));
  }
  return figures;
}

}  // namespace pf
