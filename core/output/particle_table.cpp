#include "core/output/particle_table.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/diagnostics/stress.hpp"

namespace pf {

namespace {

// Readers refuse or misdraw NaN: whatever could not be computed is written as 0.
double finite(double value) {
  return std::isfinite(value) ? value : 0;
}

template <class Get>
void add_scalar(std::vector<Column>& columns, const std::vector<ParticleState>& particles, std::string_view name,
                std::string_view unit, Get get, ColumnKind kind = ColumnKind::real) {
  Column column{name, unit, kind, 1, {}};
  column.values.reserve(particles.size());
  for (const ParticleState& particle : particles) column.values.push_back(finite(get(particle)));
  columns.push_back(std::move(column));
}

template <class Get>
void add_vector(std::vector<Column>& columns, const std::vector<ParticleState>& particles, std::string_view name,
                std::string_view unit, Get get) {
  Column column{name, unit, ColumnKind::real, 3, {}};
  column.values.reserve(3 * particles.size());
  for (const ParticleState& particle : particles) {
    const Vec3 value = get(particle);
    for (int a = 0; a < 3; ++a) column.values.push_back(finite(value[a]));
  }
  columns.push_back(std::move(column));
}

template <class Get>
void add_tensor(std::vector<Column>& columns, const std::vector<ParticleState>& particles, std::string_view name,
                std::string_view unit, Get get) {
  Column column{name, unit, ColumnKind::real, 9, {}};
  column.values.reserve(9 * particles.size());
  for (const ParticleState& particle : particles) {
    const Mat3 value = get(particle);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) column.values.push_back(finite(value(a, b)));
  }
  columns.push_back(std::move(column));
}

using Lattice = std::array<std::int32_t, 3>;

// Corners of a cell from its lowest one, in VTK's order: round the bottom, then round the top.
std::vector<Lattice> corner_offsets(int dimension) {
  std::vector<Lattice> offsets{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  if (dimension == 3)
    for (int k = 0; k < 4; ++k) offsets.push_back({offsets[k][0], offsets[k][1], 1});
  return offsets;
}

Column node_column(const Snapshot& snapshot, std::string_view name, std::string_view unit,
                   const std::vector<double>& values) {
  const auto D = static_cast<std::size_t>(snapshot.dimension);
  const std::size_t components = values.size() == snapshot.nodes ? 1 : D;
  Column column{name, unit, ColumnKind::real, components == 1 ? 1 : 3, {}};
  for (std::size_t i = 0; i < snapshot.nodes; ++i)
    for (std::size_t a = 0; a < (components == 1 ? 1 : 3); ++a)
      column.values.push_back(a < components ? finite(values[i * components + a]) : 0);
  return column;
}

}  // namespace

ParticleTable particle_table(const std::vector<ParticleState>& particles, int dimension) {
  ParticleTable table;
  table.x.reserve(3 * particles.size());
  for (const ParticleState& particle : particles)
    for (int a = 0; a < 3; ++a) table.x.push_back(a < dimension ? finite(particle.x[a]) : 0);
  std::vector<Column>& columns = table.columns;
  using P = const ParticleState&;
  add_scalar(
      columns, particles, "id", "", [](P p) { return static_cast<double>(p.id); }, ColumnKind::index);
  add_scalar(
      columns, particles, "body", "", [](P p) { return static_cast<double>(p.body); }, ColumnKind::index);
  add_scalar(
      columns, particles, "material", "", [](P p) { return static_cast<double>(p.material); }, ColumnKind::index);
  add_scalar(columns, particles, "mass", "kg", [](P p) { return p.mass; });
  add_scalar(columns, particles, "volume", "m^3", [](P p) { return p.volume0 * p.F.determinant(); });
  add_vector(columns, particles, "X", "m", [](P p) { return p.X; });
  add_vector(columns, particles, "velocity", "m/s", [](P p) { return p.v; });
  add_scalar(columns, particles, "speed", "m/s", [](P p) { return p.v.norm(); });
  add_tensor(columns, particles, "F", "", [](P p) { return p.F; });
  add_scalar(columns, particles, "J", "", [](P p) { return p.F.determinant(); });
  add_tensor(columns, particles, "stress", "Pa", [](P p) { return p.sigma; });
  add_scalar(columns, particles, "pressure", "Pa", [](P p) { return pressure(p.sigma); });
  add_scalar(columns, particles, "von_mises", "Pa", [](P p) { return von_mises(p.sigma); });
  add_scalar(columns, particles, "energy_density", "J/m^3", [](P p) { return p.energy_density; });
  return table;
}

GridTable grid_table(const Snapshot& snapshot) {
  GridTable table;
  const int D = snapshot.dimension;
  std::map<Lattice, std::uint32_t> number;
  std::vector<Lattice> nodes(snapshot.nodes, Lattice{});
  for (std::size_t i = 0; i < snapshot.nodes; ++i) {
    for (int a = 0; a < D; ++a) nodes[i][a] = snapshot.node_index[i * D + a];
    for (const std::int32_t index : nodes[i]) table.x.push_back(snapshot.spacing * index);
    number.emplace(nodes[i], static_cast<std::uint32_t>(i));
  }
  const std::vector<Lattice> offsets = corner_offsets(D);
  table.corners = static_cast<int>(offsets.size());
  for (const Lattice& low : nodes) {
    std::vector<std::uint32_t> cell;
    for (const Lattice& offset : offsets) {
      const auto found = number.find({low[0] + offset[0], low[1] + offset[1], low[2] + offset[2]});
      if (found != number.end()) cell.push_back(found->second);
    }
    if (cell.size() == offsets.size()) table.cells.insert(table.cells.end(), cell.begin(), cell.end());
  }
  table.columns.push_back(node_column(snapshot, "mass", "kg", snapshot.node_mass));
  table.columns.push_back(node_column(snapshot, "velocity", "m/s", snapshot.node_velocity));
  table.columns.push_back(node_column(snapshot, "displacement", "m", snapshot.node_displacement));
  Column state{"state", "", ColumnKind::index, 1, {}};
  for (std::size_t i = 0; i < snapshot.nodes; ++i) state.values.push_back(snapshot.node_state[i]);
  table.columns.push_back(std::move(state));
  return table;
}

}  // namespace pf
