#include "core/output/csv_table.hpp"

#include <charconv>
#include <limits>

#include "core/files.hpp"
#include "core/params/problem.hpp"

namespace pf {

namespace {

/// One row from `text` at `at`, which moves behind its end. False where the row does not end.
bool take_row(std::string_view text, std::size_t& at, std::vector<std::string>& cells) {
  cells.assign(1, "");
  bool quoted = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quoted) {
      if (c != '"')
        cells.back() += c;
      else if (at + 1 < text.size() && text[at + 1] == '"')
        cells.back() += text[++at];
      else
        quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',') {
      cells.emplace_back();
    } else if (c == '\n') {
      ++at;
      return true;
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return false;
}

}  // namespace

int CsvTable::find(std::string_view name) const {
  for (std::size_t k = 0; k < header.size(); ++k)
    if (header[k] == name) return static_cast<int>(k);
  return -1;
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

CsvTable parse_csv(std::string_view text, const std::string& source) {
  CsvTable table;
  std::size_t at = 0;
  if (!take_row(text, at, table.header))
    throw InputError(source, {{"", "no complete line", "a table with a header in its first line", 1}});
  std::vector<std::string> cells;
  for (int line = 2; at < text.size(); ++line) {
    if (!take_row(text, at, cells)) break;
    if (cells.size() != table.header.size())
      throw InputError(source, {{"", std::to_string(cells.size()) + " cells",
                                 std::to_string(table.header.size()) + ", as in the header", line}});
    table.rows.push_back(cells);
  }
  return table;
}

CsvTable read_csv(const std::filesystem::path& file) {
  return parse_csv(read_file(file), file.string());
}

double csv_value(const std::string& cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool whole = error == std::errc() && end == cell.data() + cell.size();
  return whole ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace pf
