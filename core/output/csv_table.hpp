// CSV files read back: ours, or anybody's (RFC 4180).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pf {

/// Cells as texts; every row has as many as the header.
struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  /// The column's index, or -1.
  int find(std::string_view name) const;
};

/// Text of a cell: quoted where a comma, a quote or a line's end would break the row.
std::string csv_cell(const std::string& text);
/// A last line without its end is left out: the writer was killed within it. Throws InputError (file, line) where a row
/// has another number of cells than the header.
CsvTable parse_csv(std::string_view text, const std::string& source);
/// Throws FileError, InputError.
CsvTable read_csv(const std::filesystem::path& file);
/// The number in a cell; NaN where it is none.
double csv_value(const std::string& cell);

}  // namespace pf
