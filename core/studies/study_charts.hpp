// The charts of a study: from rows to a Chart, which core/charts draws in the app and into files.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/charts/chart.hpp"
#include "core/studies/row.hpp"
#include "core/studies/study.hpp"

namespace pf {

/// Which setting each point of a chart belongs to: `point[s][k]` for point k of series s; empty for series that show no
/// runs. The app turns a click into a setting with it.
struct StudyFigure {
  std::string name;  ///< of its files: "chart", "chart-dt"
  Chart chart;
  std::vector<std::vector<std::size_t>> point;
  std::vector<std::size_t> cell;       ///< of a map: the setting of each cell
  std::size_t x_axis = 0, y_axis = 0;  ///< of a map: which of the study's axes it shows
  std::vector<std::size_t> others;     ///< of a map: index of the value on each axis, 0 on the two that it shows
  std::string label;                   ///< of a map: what is special to it: "Backward Euler"
  bool is_map() const { return x_axis != y_axis; }
};

/// The charts that a study asks for, or those that suit its kind: error against cost; a map for each value of what is
/// not an axis. Rows that are not there yet are left out.
std::vector<StudyFigure> study_figures(const Study& study, std::span<const StudyRow> rows);

StudyFigure line_figure(const Study& study, std::span<const StudyRow> rows, const StudyChart& spec);
std::vector<StudyFigure> map_figures(const Study& study, std::span<const StudyRow> rows);

/// FOLDER/NAME.svg, .png and .csv of each. Throws FileError.
void write_figures(std::span<const StudyFigure> figures, const Study& study, const std::filesystem::path& folder);

/// "Implicit midpoint", "0.95", "1e5 Pa": a varied value for people.
std::string value_label(const std::string& column, const nlohmann::json& value);
/// "Time step": a varied column, or one of results.csv, for people; its unit.
std::pair<std::string, std::string> column_title(const Study& study, const std::string& column);

}  // namespace pf
