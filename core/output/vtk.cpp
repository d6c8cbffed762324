// VTK XML files (.vtp, .vtu, .pvd), arrays inline in base64: still well-formed XML, and bit-exact.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/files.hpp"
#include "core/output/export.hpp"

namespace pf {

namespace {

void append_base64(std::string& out, const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= count ? digits[word >> (18 - 6 * k) & 63] : '=';
  }
}

template <class T>
constexpr const char* vtk_type();
template <>
constexpr const char* vtk_type<double>() {
  return "Float64";
}
template <>
constexpr const char* vtk_type<std::uint32_t>() {
  return "UInt32";
}
template <>
constexpr const char* vtk_type<std::int64_t>() {
  return "Int64";
}
template <>
constexpr const char* vtk_type<std::uint8_t>() {
  return "UInt8";
}

template <class T, class Values>
void append_array(std::string& out, std::string_view name, int components, const Values& values) {
  std::string bytes;
  const std::uint64_t length = values.size() * sizeof(T);
  bytes.reserve(sizeof length + length);
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  for (const auto& value : values) {
    const T typed = static_cast<T>(value);
    bytes.append(reinterpret_cast<const char*>(&typed), sizeof typed);
  }
  out += "<DataArray type=\"" + std::string(vtk_type<T>()) + "\" Name=\"" + std::string(name) +
         "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"binary\">";
  append_base64(out, bytes);
  out += "</DataArray>\n";
}

void append_columns(std::string& out, const std::vector<Column>& columns) {
  out += "<PointData>\n";
  for (const Column& column : columns)
    if (column.kind == ColumnKind::index)
      append_array<std::uint32_t>(out, column.name, column.components, column.values);
    else
      append_array<double>(out, column.name, column.components, column.values);
  out += "</PointData>\n";
}

std::string opening(std::string_view type, double time) {
  std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + std::string(type) +
                    "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" + std::string(type) +
                    ">\n<FieldData>\n";
  append_array<double>(out, "TimeValue", 1, std::array<double, 1>{time});
  // The reader wants to be told how many.
  out.replace(out.find("NumberOfComponents=\"1\""), std::strlen("NumberOfComponents=\"1\""), "NumberOfTuples=\"1\"");
  return out + "</FieldData>\n";
}

void append_points(std::string& out, const std::vector<double>& x) {
  out += "<Points>\n";
  append_array<double>(out, "Points", 3, x);
  out += "</Points>\n";
}

// 0, 1, 2, ... and the ends of groups of `size`.
std::vector<std::int64_t> counting(std::size_t count, std::int64_t first, std::int64_t step) {
  std::vector<std::int64_t> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = first + step * static_cast<std::int64_t>(i);
  return values;
}

}  // namespace

std::string vtk_particles(const ParticleTable& table, double time) {
  const std::string count = std::to_string(table.size());
  std::string out = opening("PolyData", time);
  out += "<Piece NumberOfPoints=\"" + count + "\" NumberOfVerts=\"" + count +
         "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
  append_columns(out, table.columns);
  append_points(out, table.x);
  out += "<Verts>\n";
  append_array<std::int64_t>(out, "connectivity", 1, counting(table.size(), 0, 1));
  append_array<std::int64_t>(out, "offsets", 1, counting(table.size(), 1, 1));
  return out + "</Verts>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string vtk_grid(const GridTable& table, double time) {
  constexpr std::uint8_t quadrilateral = 9, hexahedron = 12;  // VTK's cell types
  const std::size_t cells = table.cells.size() / static_cast<std::size_t>(table.corners);
  std::string out = opening("UnstructuredGrid", time);
  out += "<Piece NumberOfPoints=\"" + std::to_string(table.size()) + "\" NumberOfCells=\"" + std::to_string(cells) +
         "\">\n";
  append_columns(out, table.columns);
  append_points(out, table.x);
  out += "<Cells>\n";
  append_array<std::int64_t>(out, "connectivity", 1, table.cells);
  append_array<std::int64_t>(out, "offsets", 1, counting(cells, table.corners, table.corners));
  append_array<std::uint8_t>(out, "types", 1,
                             std::vector<std::uint8_t>(cells, table.corners == 4 ? quadrilateral : hexahedron));
  return out + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string vtk_index(std::span<const FrameTime> frames) {
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const FrameTime& frame : frames) {
    out += "<DataSet timestep=\"";
    append_number(out, frame.time);
    out += "\" part=\"0\" file=\"" + particles_file(frame.number, "vtp") + "\"/>\n";
  }
  return out + "</Collection>\n</VTKFile>\n";
}

}  // namespace pf
