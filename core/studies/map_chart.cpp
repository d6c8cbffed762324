// A stability map: colour is what was measured, hatching is the class.
#include <algorithm>
#include <cmath>

#include "core/charts/colormap.hpp"
#include "core/math/expression.hpp"
#include "core/studies/study_charts.hpp"

namespace pf {

namespace {

struct ClassStyle {
  RunClass behaviour;
  const char* label;
  Hatch hatch;
};
constexpr ClassStyle styles[] = {
    {RunClass::good, "good", Hatch::none},         {RunClass::damped, "damped", Hatch::dotted},
    {RunClass::noisy, "noisy", Hatch::horizontal}, {RunClass::growing, "growing", Hatch::rising},
    {RunClass::failed, "failed", Hatch::falling},  {RunClass::blown_up, "blown up", Hatch::crossed}};
constexpr Color unknown{0.72f, 0.72f, 0.72f, 1};

std::vector<double> numbers_of(const StudyAxis& axis) {
  std::vector<double> values;
  for (const StudyValue& value : axis.values) values.push_back(value.edits.front().value.get<double>());
  return values;
}

bool is_number_axis(const StudyAxis& axis) {
  return axis.is_pointer() && axis.values.size() > 1 &&
         std::all_of(axis.values.begin(), axis.values.end(),
                     [](const StudyValue& v) { return v.edits.front().value.is_number(); });
}

/// One axis of a map: where each value's cell begins and ends.
class MapAxis {
 public:
  explicit MapAxis(const StudyAxis& axis) : values_(numbers_of(axis)) {
    std::vector<double> sorted = values_;
    std::sort(sorted.begin(), sorted.end());
    logarithmic_ = sorted.front() > 0 && sorted.back() > 8 * sorted.front();
  }
  AxisScale scale() const { return logarithmic_ ? AxisScale::logarithmic : AxisScale::linear; }

  /// The stretch nearest to value k among the values that are there (`present`), which the k-th is.
  std::pair<double, double> cell(std::size_t k, const std::vector<bool>& present) const {
    const double here = to(values_[k]);
    double below = -INFINITY, above = INFINITY;
    for (std::size_t j = 0; j < values_.size(); ++j) {
      if (!present[j]) continue;
      const double there = to(values_[j]);
      if (there < here) below = std::max(below, there);
      if (there > here) above = std::min(above, there);
    }
    const double step_up = std::isfinite(above) ? above - here : std::isfinite(below) ? here - below : 1;
    const double step_down = std::isfinite(below) ? here - below : step_up;
    return {from(here - 0.5 * step_down), from(here + 0.5 * step_up)};
  }

 private:
  double to(double value) const { return logarithmic_ ? std::log10(value) : value; }
  double from(double value) const { return logarithmic_ ? std::pow(10, value) : value; }
  std::vector<double> values_;
  bool logarithmic_ = false;
};

/// From measured values to colours.
struct Scale {
  ColorBar bar;
  double low = 0, high = 1;
  bool logarithmic = false;
  Color color(double value) const {
    if (std::isnan(value)) return unknown;
    const double t = logarithmic
                         ? (std::log10(std::max(value, low)) - std::log10(low)) / (std::log10(high) - std::log10(low))
                         : (value - low) / (high - low);
    return sample(bar.map, std::clamp(t, 0.0, 1.0));
  }
};

Scale scale_of(const Study& study, std::span<const StudyRow> rows, const RowColumn& column) {
  std::vector<double> values;
  for (const StudyRow& row : rows)
    if (std::isfinite(row.*column.member)) values.push_back(row.*column.member);
  std::sort(values.begin(), values.end());
  Scale scale;
  const double most = values.empty() ? 1 : values.back(), least = values.empty() ? 0 : values.front();
  if (column.member == &StudyRow::energy_change) {
    // Loss can be all there is, gain has no end: beyond one both ends are one colour.
    scale.bar.map = ColormapKind::diverging;
    scale.high = std::clamp(std::max(most, -least), 0.05, 1.0);
    scale.low = -scale.high;
  } else {
    const double largest = column.member == &StudyRow::energy_gained ? std::min(most, study.thresholds.blown_up) : most;
    const auto positive = std::find_if(values.begin(), values.end(), [](double v) { return v > 0; });
    const double smallest = positive == values.end() ? 0 : std::max(*positive, 1e-6 * largest);
    scale.logarithmic = smallest > 0 && largest > 30 * smallest;
    scale.low = scale.logarithmic ? smallest : std::min(0.0, least);
    scale.high = largest > scale.low ? largest : scale.low + 1;
  }
  const auto [title, unit] = column_title(study, std::string(column.name));
  scale.bar.axis = {.title = title,
                    .unit = unit,
                    .scale = scale.logarithmic ? AxisScale::logarithmic : AxisScale::linear,
                    .min = scale.low,
                    .max = scale.high};
  return scale;
}

std::string threshold_text(const Study& study) {
  char text[200];
  const StudyThresholds& t = study.thresholds;
  std::snprintf(text, sizeof text,
                "damped: energy lost > %g; noisy: stress noise > %g; growing: gained > %g; blown up: > %g", t.damped,
                t.noisy, t.growing, t.blown_up);
  return text;
}

void add_limits(const Study& study, const Chart& frame, Chart& chart) {
  constexpr int pieces = 1000;
  for (const StudyLimit& limit : study.limits) {
    const bool up = !limit.y.empty();  // y as a function of x
    const Axis& axis = up ? frame.x : frame.y;
    const Expression expression = Expression::compile(up ? limit.y : limit.x, {}, 1u << (up ? var_x : var_y));
    Series series{.label = limit.label, .ink = true, .outlined = true};
    series.dashed = chart.series.size() % 2 == 1;
    for (int k = 0; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces, low = *axis.min, high = *axis.max;
      const double at = axis.scale == AxisScale::logarithmic ? low * std::pow(high / low, t) : low + t * (high - low);
      double arguments[variable_count] = {};
      arguments[up ? var_x : var_y] = at;
      const double value = expression(arguments);
      const Axis& other = up ? frame.y : frame.x;
      if (!(value >= *other.min && value <= *other.max)) {
        series.x.push_back(not_measured), series.y.push_back(not_measured);  // breaks the line at the map's edge
        continue;
      }
      series.x.push_back(up ? at : value);
      series.y.push_back(up ? value : at);
    }
    chart.series.push_back(std::move(series));
  }
}

/// The settings that one map shows: those with the same values on the axes that it does not draw.
struct Panel {
  std::vector<std::size_t> others;
  std::vector<const StudyRow*> rows;
};

struct Axes {
  std::size_t x = 0, y = 0;
};

Axes drawn_axes(const Study& study) {
  std::vector<std::size_t> numbers;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (is_number_axis(study.axes[a])) numbers.push_back(a);
  return numbers.size() < 2 ? Axes{} : Axes{numbers[0], numbers[1]};
}

std::string panel_label(const Study& study, const Panel& panel, const Axes& axes) {
  std::string label;
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    if (a == axes.x || a == axes.y) continue;
    const StudyValue& value = study.axes[a].values[panel.others[a]];
    const std::string text = !value.label.empty() || value.edits.empty()
                                 ? value.label
                                 : value_label(value.edits.front().pointer, value.edits.front().value);
    label += (label.empty() ? "" : ", ") + text;
  }
  return label;
}

std::string file_name(const std::string& label) {
  std::string name = "chart";
  bool gap = true;
  for (const char c : label) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
    if (plain && gap) name += '-';
    if (plain) name += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    gap = !plain;
  }
  return name;
}

/// Coarse runs first, finer ones over them: cells shrink as the map fills.
void add_cells(const Study& study, const Panel& panel, const Axes& axes, const Scale& scale, const RowColumn& column,
               StudyFigure& figure) {
  const MapAxis x(study.axes[axes.x]), y(study.axes[axes.y]);
  std::vector<std::vector<const StudyRow*>> at(study.axes[axes.x].values.size(),
                                               std::vector<const StudyRow*>(study.axes[axes.y].values.size()));
  std::vector<bool> columns(at.size()), lines(study.axes[axes.y].values.size());
  for (const StudyRow* row : panel.rows) {
    const StudyPoint point = study_point(study, row->point);
    at[point.at[axes.x]][point.at[axes.y]] = row;
    columns[point.at[axes.x]] = true;
    lines[point.at[axes.y]] = true;
  }
  for (std::size_t i = 0; i < at.size(); ++i)
    for (std::size_t j = 0; j < lines.size(); ++j) {
      const StudyRow* row = at[i][j];
      if (row == nullptr) continue;
      const auto [x_min, x_max] = x.cell(i, columns);
      const auto [y_min, y_max] = y.cell(j, lines);
      const auto style = std::find_if(std::begin(styles), std::end(styles),
                                      [&](const ClassStyle& s) { return s.behaviour == row->behaviour; });
      figure.chart.cells.push_back({x_min, x_max, y_min, y_max, scale.color(row->*column.member), style->hatch, ""});
      figure.cell.push_back(row->point);
    }
}

}  // namespace

std::vector<StudyFigure> map_figures(const Study& study, std::span<const StudyRow> rows) {
  const Axes axes = drawn_axes(study);
  const RowColumn* column = find_row_column(study.measure.empty() ? "energy_change" : study.measure);
  if (axes.x == axes.y || column == nullptr) return {};
  std::vector<Panel> panels;
  for (const StudyRow& row : rows) {
    std::vector<std::size_t> others = study_point(study, row.point).at;
    others[axes.x] = others[axes.y] = 0;
    auto found = std::find_if(panels.begin(), panels.end(), [&](const Panel& p) { return p.others == others; });
    if (found == panels.end()) found = panels.insert(panels.end(), Panel{others, {}});
    found->rows.push_back(&row);
  }
  std::sort(panels.begin(), panels.end(), [](const Panel& a, const Panel& b) { return a.others < b.others; });
  const Scale scale = scale_of(study, rows, *column);
  std::vector<StudyFigure> figures;
  for (const Panel& panel : panels) {
    const std::string label = panel_label(study, panel, axes);
    StudyFigure& figure = figures.emplace_back();
    figure.x_axis = axes.x;
    figure.y_axis = axes.y;
    figure.others = panel.others;
    figure.label = label;
    figure.name = panels.size() == 1 || figures.size() == 1 ? "chart" : file_name(label);
    Chart& chart = figure.chart;
    chart.title = study.name + (label.empty() ? "" : ": " + label);
    chart.subtitle = threshold_text(study);
    for (const bool across : {true, false}) {
      const StudyAxis& axis = study.axes[across ? axes.x : axes.y];
      const auto [title, unit] = column_title(study, axis.key);
      const MapAxis map(axis);
      (across ? chart.x : chart.y) = {.title = title, .unit = unit, .scale = map.scale()};
    }
    add_cells(study, panel, axes, scale, *column, figure);
    chart.x.min = chart.y.min = INFINITY;
    chart.x.max = chart.y.max = -INFINITY;
    for (const Cell& cell : chart.cells) {
      chart.x.min = std::min(*chart.x.min, cell.x_min), chart.x.max = std::max(*chart.x.max, cell.x_max);
      chart.y.min = std::min(*chart.y.min, cell.y_min), chart.y.max = std::max(*chart.y.max, cell.y_max);
    }
    chart.color_bar = scale.bar;
    for (const ClassStyle& style : styles)
      if (std::any_of(panel.rows.begin(), panel.rows.end(),
                      [&](const StudyRow* r) { return r->behaviour == style.behaviour; }))
        chart.keys.push_back({style.label, {0.86f, 0.86f, 0.86f, 1}, style.hatch});
    add_limits(study, chart, chart);
    chart.legend = LegendPlace::below;
  }
  return figures;
}

}  // namespace pf
