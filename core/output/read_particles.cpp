#include "core/output/read_particles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <sstream>

#include "core/files.hpp"
#include "core/output/csv_table.hpp"
#include "core/params/problem.hpp"

namespace pf {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void refuse(const std::string& source, const std::string& found, const std::string& allowed) {
  throw InputError(source, {{"", found, allowed, 0}});
}

/// "stress_xy [Pa]" -> "stress"; "x" alone is the position's.
std::string field_of(std::string name) {
  name = name.substr(0, name.find(" ["));
  if (name == "x" || name == "y" || name == "z") return "position";
  if (name == "vx" || name == "vy" || name == "vz") return "velocity";
  const auto underscore = name.rfind('_');
  if (underscore == std::string::npos) return name;
  const std::string tail = name.substr(underscore + 1);
  const bool axes = !tail.empty() && tail.size() <= 2 && tail.find_first_not_of("xyz") == std::string::npos;
  return axes ? name.substr(0, underscore) : name;
}

/// Columns that follow one another under one name are its components.
struct Grouped {
  std::vector<ReadField> fields;
  std::vector<std::size_t> field_of_column;
  explicit Grouped(const std::vector<std::string>& columns) {
    for (const std::string& column : columns) {
      const std::string name = field_of(column);
      if (fields.empty() || fields.back().name != name) fields.push_back({name, 0, {}});
      ++fields.back().components;
      field_of_column.push_back(fields.size() - 1);
    }
  }
};

ReadParticles from_csv(const std::string& text, const std::string& source) {
  const CsvTable table = parse_csv(text, source);
  Grouped grouped(table.header);
  for (const auto& row : table.rows)
    for (std::size_t k = 0; k < row.size(); ++k)
      grouped.fields[grouped.field_of_column[k]].values.push_back(csv_value(row[k]));
  return {unknown, std::move(grouped.fields)};
}

template <class T>
double take(const std::string& bytes, std::size_t& at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  at += sizeof value;
  return static_cast<double>(value);
}

ReadParticles from_ply(const std::string& text, const std::string& source) {
  const std::size_t end = text.find("end_header\n");
  if (end == std::string::npos) refuse(source, "no end of a header", "a PLY file as run --export=ply writes it");
  std::istringstream header(text.substr(0, end));
  ReadParticles read{unknown, {}};
  std::size_t count = 0;
  std::vector<std::string> names, types;
  for (std::string line; std::getline(header, line);) {
    std::istringstream words(line);
    std::string first, type, name;
    words >> first >> type >> name;
    if (first == "comment" && line.find(", time ") != std::string::npos)
      read.time = std::strtod(line.c_str() + line.find(", time ") + 7, nullptr);
    if (first == "element") count = std::strtoull(name.c_str(), nullptr, 10);
    if (first != "property") continue;
    names.push_back(name);
    types.push_back(type);
  }
  std::size_t row = 0;
  for (const std::string& type : types) row += type == "double" ? 8 : 4;
  std::size_t at = end + std::strlen("end_header\n");
  if (row == 0 || text.size() - at != count * row)
    refuse(source, "another length than its header says", "a whole file");
  Grouped grouped(names);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < types.size(); ++k)
      grouped.fields[grouped.field_of_column[k]].values.push_back(types[k] == "double" ? take<double>(text, at)
                                                                  : types[k] == "uint" ? take<std::uint32_t>(text, at)
                                                                                       : take<float>(text, at));
  read.fields = std::move(grouped.fields);
  return read;
}

std::string from_base64(std::string_view digits) {
  static const std::array<int, 256> value = [] {
    std::array<int, 256> table{};
    table.fill(-1);
    const std::string_view all = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t k = 0; k < all.size(); ++k) table[static_cast<unsigned char>(all[k])] = static_cast<int>(k);
    return table;
  }();
  std::string bytes;
  std::uint32_t word = 0;
  int bits = 0;
  for (const char c : digits) {
    const int six = value[static_cast<unsigned char>(c)];
    if (six < 0) break;
    word = word << 6 | static_cast<std::uint32_t>(six);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(word >> bits & 255);
  }
  return bytes;
}

std::string attribute(std::string_view tag, const std::string& name) {
  const std::size_t at = tag.find(name + "=\"");
  if (at == std::string_view::npos) return "";
  const std::size_t begin = at + name.size() + 2;
  return std::string(tag.substr(begin, tag.find('"', begin) - begin));
}

ReadParticles from_vtp(const std::string& text, const std::string& source) {
  ReadParticles read{unknown, {}};
  const std::string opening = "<DataArray ";
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    const std::size_t close = text.find('>', at), end = text.find("</DataArray>", at);
    if (close == std::string::npos || end == std::string::npos)
      refuse(source, "an array without its end", "a whole file");
    const std::string_view tag(text.data() + at, close - at);
    const std::string name = attribute(tag, "Name"), type = attribute(tag, "type");
    const std::string bytes = from_base64({text.data() + close + 1, end - close - 1});
    at = end;
    ReadField field{name == "Points" ? "position" : name, 1, {}};
    if (const std::string count = attribute(tag, "NumberOfComponents"); !count.empty())
      field.components = std::max<std::size_t>(1, std::strtoull(count.c_str(), nullptr, 10));
    for (std::size_t place = 8; type == "Float64" && place + 8 <= bytes.size();)
      field.values.push_back(take<double>(bytes, place));
    for (std::size_t place = 8; type == "UInt32" && place + 4 <= bytes.size();)
      field.values.push_back(take<std::uint32_t>(bytes, place));
    if (name == "TimeValue" && !field.values.empty())
      read.time = field.values.front();
    else if (!field.values.empty())
      read.fields.push_back(std::move(field));
  }
  if (read.fields.empty()) refuse(source, "no array of numbers", "a VTK file as run --export=vtk writes it");
  return read;
}

}  // namespace

const ReadField* ReadParticles::find(const std::string& name) const {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const ReadField& f) { return f.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

ReadParticles read_particles(const std::filesystem::path& file) {
  const std::string text = read_file(file), extension = file.extension().string();
  if (extension == ".vtp") return from_vtp(text, file.string());
  if (extension == ".ply") return from_ply(text, file.string());
  return from_csv(text, file.string());
}

}  // namespace pf
