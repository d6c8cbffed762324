// The fields of particles and nodes that can be drawn: one table.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace pf {

// clang-format off
enum class Field : std::uint8_t {
  speed, J, von_mises, pressure, energy_density, material, error,
  velocity_x, velocity_y, velocity_z, kinetic_density,
  displacement, displacement_x, displacement_y, displacement_z,
  stretch_1, stretch_2, stretch_3, strain_equivalent,
  strain_xx, strain_yy, strain_zz, strain_xy, strain_yz, strain_xz,
  stress_1, stress_2, stress_3, shear,
  stress_xx, stress_yy, stress_zz, stress_xy, stress_yz, stress_xz,
  node_mass, node_speed, node_velocity_x, node_velocity_y, node_velocity_z, node_displacement,
  node_force, node_force_x, node_force_y, node_force_z, node_residual,
};
// clang-format on
inline constexpr int field_count = static_cast<int>(Field::node_residual) + 1;

/// Its bit in SnapshotRequest::fields.
constexpr std::uint64_t field_bit(Field field) {
  return std::uint64_t{1} << static_cast<unsigned>(field);
}

enum class FieldScale { sequential, diverging, categorical };

struct FieldInfo {
  Field field;
  std::string_view key;    ///< as in view.color_by
  std::string_view label;  ///< plain name
  std::string_view unit;   ///< SI
  FieldScale scale;
  double centre;            ///< of a diverging map
  std::string_view group;   ///< in menus: those of a group follow one another
  bool on_nodes = false;    ///< of the grid's nodes; else of particles
  bool only_in_3d = false;  ///< 0 in plane strain, or not there
};

std::span<const FieldInfo> fields();
const FieldInfo& field_info(Field field);
const FieldInfo* find_field(std::string_view key);

}  // namespace pf
