// Any table as a chart: columns of CSV files against each other, a line a table, a column or a value.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/charts/chart.hpp"

namespace pf {

struct TableChart {
  std::vector<std::filesystem::path> tables = {};  ///< CSV files with a header; a folder means the stats.csv in it
  std::string x = {};                              ///< column
  std::vector<std::string> y = {};                 ///< columns; without x_title and y_title columns name the axes
  std::string lines = {};                          ///< a column whose values tell lines apart; "": none
  std::string title = {}, subtitle = {};
  std::string x_title = {}, y_title = {};  ///< "CPU time [s]"
  bool log_x = false, log_y = false;
  std::vector<double> slopes = {};  ///< of triangles
  bool pareto = false;              ///< rings the points that no other beats in both x and y
};

/// One line for each table, y and value of `lines`, points in the rows' order; a cell that is no number breaks the
/// line. Throws FileError; InputError for a column that a table lacks (nearest named) and for one without any number.
Chart table_chart(const TableChart& wanted);

/// "CPU time [s]" as title and unit.
std::pair<std::string, std::string> split_unit(const std::string& title);

}  // namespace pf
