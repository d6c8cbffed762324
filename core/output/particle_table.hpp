// The state as columns: what every export format writes, each in its own way.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/simulation.hpp"

namespace pf {

enum class ColumnKind { real, index };

/// One quantity of every particle or node, `components` numbers each, interleaved. Tensors have 9 components by
/// rows. Values are finite.
struct Column {
  std::string_view name;  ///< "von_mises"
  std::string_view unit;  ///< SI, "" when dimensionless
  ColumnKind kind = ColumnKind::real;
  int components = 1;
  std::vector<double> values;
};

/// All particles, ordered by id.
struct ParticleTable {
  std::vector<double> x;  ///< [m], three components each, z = 0 in 2D
  std::vector<Column> columns;
  std::size_t size() const { return x.size() / 3; }
};

ParticleTable particle_table(const std::vector<ParticleState>& particles, int dimension);

/// The active grid: nodes where they are on the lattice, and the cells all of whose corners are active.
struct GridTable {
  std::vector<double> x;  ///< [m], three components each
  std::vector<Column> columns;
  std::vector<std::uint32_t> cells;  ///< corners, 4 a cell in 2D, 8 in 3D, in VTK's order
  int corners = 4;                   ///< of a cell
  std::size_t size() const { return x.size() / 3; }
};

/// `snapshot` holds nodes (SnapshotRequest::grid).
GridTable grid_table(const Snapshot& snapshot);

}  // namespace pf
