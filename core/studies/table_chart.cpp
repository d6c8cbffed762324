#include "core/studies/table_chart.hpp"

#include <algorithm>
#include <cmath>

#include "core/output/csv_table.hpp"
#include "core/params/nearest.hpp"
#include "core/params/problem.hpp"

namespace pf {

namespace {

namespace fs = std::filesystem;

std::size_t column(const CsvTable& table, const fs::path& file, const std::string& name) {
  const int found = table.find(name);
  if (found < 0) throw InputError(file.string(), {{"", "no column \"" + name + "\"", suggest(name, table.header)}});
  return static_cast<std::size_t>(found);
}

/// What tells tables apart: their names, or where all have the same one, their folders'.
std::vector<std::string> table_labels(const std::vector<fs::path>& tables) {
  const bool same = std::all_of(tables.begin(), tables.end(),
                                [&](const fs::path& table) { return table.filename() == tables.front().filename(); });
  std::vector<std::string> labels;
  labels.reserve(tables.size());
  for (const fs::path& table : tables)
    labels.push_back((same ? fs::absolute(table).parent_path().filename() : table.stem()).string());
  return labels;
}

Series& line_of(Chart& chart, const std::string& label) {
  for (Series& series : chart.series)
    if (series.label == label) return series;
  const std::size_t k = chart.series.size();
  chart.series.push_back({.label = label, .color_index = k % 8, .dashed = k >= 8});
  return chart.series.back();
}

/// A column's name as words, and the unit of those that the program writes itself (INTERFACE, stats.csv).
std::pair<std::string, std::string> usual_title(const std::string& name) {
  std::string title = name;
  std::replace(title.begin(), title.end(), '_', ' ');
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
  if (name == "wall_ms") return {"Wall time of a step [ms]", ""};
  if (name.ends_with("_energy")) return {title, "J"};
  if (name.starts_with("momentum_")) return {title, "N s"};
  if (name.starts_with("angular_momentum_")) return {title, "N m s"};
  const bool seconds = name == "time" || name == "dt" || name == "stable_step" || name == "explicit_limit";
  return {title, seconds ? "s" : ""};
}

Axis make_axis(const std::string& title, const std::vector<std::string>& columns, bool logarithmic) {
  auto [words, unit] = split_unit(title);
  if (title.empty()) std::tie(words, unit) = usual_title(columns.front());
  for (std::size_t k = 1; title.empty() && k < columns.size(); ++k)
    if (usual_title(columns[k]).second != unit) unit.clear();
  if (title.empty() && columns.size() > 1) words = unit == "J" ? "Energy" : "";
  return {.title = words, .unit = unit, .scale = logarithmic ? AxisScale::logarithmic : AxisScale::linear};
}

/// Few points are seen one by one.
void choose_style(Series& series, std::size_t index) {
  constexpr MarkShape shapes[] = {MarkShape::circle, MarkShape::square, MarkShape::triangle, MarkShape::diamond};
  constexpr std::size_t few = 40;
  if (series.x.size() > few) return;
  series.style = SeriesStyle::line_and_points;
  series.mark = shapes[index % 4];
}

}  // namespace

std::pair<std::string, std::string> split_unit(const std::string& title) {
  const std::size_t unit = title.rfind(" [");
  if (unit == std::string::npos || !title.ends_with(']')) return {title, ""};
  return {title.substr(0, unit), title.substr(unit + 2, title.size() - unit - 3)};
}

Chart table_chart(const TableChart& wanted) {
  Chart chart;
  std::vector<fs::path> files = wanted.tables;
  for (fs::path& file : files)
    if (fs::is_directory(file)) file /= "stats.csv";
  const std::vector<std::string> labels = table_labels(files);
  for (std::size_t t = 0; t < files.size(); ++t) {
    const CsvTable table = read_csv(files[t]);
    const std::size_t x = column(table, files[t], wanted.x);
    const int lines = wanted.lines.empty() ? -1 : static_cast<int>(column(table, files[t], wanted.lines));
    for (const std::string& name : wanted.y) {
      const std::size_t y = column(table, files[t], name);
      bool any = false;
      for (const std::vector<std::string>& row : table.rows) {
        std::string label = files.size() > 1 ? labels[t] : "";
        if (lines >= 0) label += (label.empty() ? "" : ", ") + row[static_cast<std::size_t>(lines)];
        if (wanted.y.size() > 1) label += (label.empty() ? "" : ", ") + usual_title(name).first;
        Series& series = line_of(chart, label);
        series.x.push_back(csv_value(row[x]));
        series.y.push_back(csv_value(row[y]));
        any = any || (std::isfinite(series.x.back()) && std::isfinite(series.y.back()));
      }
      if (!any)
        throw InputError(files[t].string(),
                         {{"", "no row with numbers in \"" + wanted.x + "\" and \"" + name + "\"", "one or more"}});
    }
  }
  for (std::size_t k = 0; k < chart.series.size(); ++k) choose_style(chart.series[k], k);
  chart.title = wanted.title;
  chart.subtitle = wanted.subtitle;
  chart.x = make_axis(wanted.x_title, {wanted.x}, wanted.log_x);
  chart.y = make_axis(wanted.y_title, wanted.y, wanted.log_y);
  for (const double slope : wanted.slopes) chart.triangles.push_back({.slope = slope});
  chart.mark_pareto = wanted.pareto;
  chart.pareto_ties = 0.01;
  if (chart.series.size() > 5) chart.legend = LegendPlace::outside_right;
  return chart;
}

}  // namespace pf
