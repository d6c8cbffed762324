// A row a particle, 17 digits; the header names component and unit: "velocity_x [m/s]".
#include "core/files.hpp"
#include "core/output/export.hpp"

namespace pf {

namespace {

void append_header(std::string& out, const Column& column) {
  constexpr const char* axis = "xyz";
  for (int k = 0; k < column.components; ++k) {
    out += "," + std::string(column.name);
    if (column.components == 9) out += std::string("_") + axis[k / 3] + axis[k % 3];
    if (column.components == 3) out += std::string("_") + axis[k];
    if (!column.unit.empty()) out += " [" + std::string(column.unit) + "]";
  }
}

}  // namespace

std::string csv_particles(const ParticleTable& table, double /*time*/) {
  std::string out = "x [m],y [m],z [m]";
  for (const Column& column : table.columns) append_header(out, column);
  out += '\n';
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (a > 0) out += ',';
      append_number(out, table.x[3 * i + a]);
    }
    for (const Column& column : table.columns)
      for (int k = 0; k < column.components; ++k) {
        out += ',';
        append_number(out, column.values[i * static_cast<std::size_t>(column.components) + k]);
      }
    out += '\n';
  }
  return out;
}

}  // namespace pf
