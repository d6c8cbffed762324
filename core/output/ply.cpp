// Binary PLY (little-endian): positions in double, everything else in float.
#include <cstdint>

#include "core/files.hpp"
#include "core/output/export.hpp"

namespace pf {

namespace {

constexpr const char* axis[] = {"x", "y", "z"};

// "velocity" -> vx vy vz; "F" -> F_xx F_xy ...: PLY properties are scalars.
std::string property_name(const Column& column, int component) {
  const std::string name(column.name);
  if (column.components == 1) return name;
  if (column.components == 9) return name + "_" + axis[component / 3] + axis[component % 3];
  if (name == "velocity") return std::string("v") + axis[component];
  return name + "_" + axis[component];
}

template <class T>
void append_bytes(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::string ply_particles(const ParticleTable& table, double time) {
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment pushforward, SI units, time ";
  append_number(out, time);
  out += "\nelement vertex " + std::to_string(table.size()) + "\n";
  for (const char* name : axis) out += std::string("property double ") + name + "\n";
  for (const Column& column : table.columns)
    for (int k = 0; k < column.components; ++k)
      out += std::string("property ") + (column.kind == ColumnKind::index ? "uint " : "float ") +
             property_name(column, k) + "\n";
  out += "end_header\n";
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t a = 0; a < 3; ++a) append_bytes(out, table.x[3 * i + a]);
    for (const Column& column : table.columns)
      for (int k = 0; k < column.components; ++k) {
        const double value = column.values[i * static_cast<std::size_t>(column.components) + k];
        if (column.kind == ColumnKind::index)
          append_bytes(out, static_cast<std::uint32_t>(value));
        else
          append_bytes(out, static_cast<float>(value));
      }
  }
  return out;
}

}  // namespace pf
