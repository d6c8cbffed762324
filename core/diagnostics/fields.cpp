#include "core/diagnostics/fields.hpp"

#include <array>

namespace pf {

namespace {

constexpr auto seq = FieldScale::sequential, div = FieldScale::diverging, cat = FieldScale::categorical;
constexpr std::string_view usual = "Most used", motion = "Motion", strain = "Strain", stress = "Stress",
                           nodes = "Grid nodes";

// clang-format off
constexpr std::array<FieldInfo, field_count> table{{
    {Field::speed, "speed", "Speed", "m/s", seq, 0, usual},
    {Field::J, "J", "Volume ratio J", "", div, 1, usual},
    {Field::von_mises, "von_mises", "von Mises stress", "Pa", seq, 0, usual},
    {Field::pressure, "pressure", "Pressure", "Pa", div, 0, usual},
    {Field::energy_density, "energy_density", "Energy density", "J/m\xc2\xb3", seq, 0, usual},
    {Field::material, "material", "Material", "", cat, 0, usual},
    {Field::error, "error", "Displacement error", "m", seq, 0, usual},
    {Field::velocity_x, "velocity_x", "Velocity x", "m/s", div, 0, motion},
    {Field::velocity_y, "velocity_y", "Velocity y", "m/s", div, 0, motion},
    {Field::velocity_z, "velocity_z", "Velocity z", "m/s", div, 0, motion, false, true},
    {Field::kinetic_density, "kinetic_density", "Kinetic energy density", "J/m\xc2\xb3", seq, 0, motion},
    {Field::displacement, "displacement", "Displacement", "m", seq, 0, motion},
    {Field::displacement_x, "displacement_x", "Displacement x", "m", div, 0, motion},
    {Field::displacement_y, "displacement_y", "Displacement y", "m", div, 0, motion},
    {Field::displacement_z, "displacement_z", "Displacement z", "m", div, 0, motion, false, true},
    {Field::stretch_1, "stretch_1", "Largest stretch", "", div, 1, strain},
    {Field::stretch_2, "stretch_2", "Second stretch", "", div, 1, strain},
    {Field::stretch_3, "stretch_3", "Third stretch", "", div, 1, strain, false, true},
    {Field::strain_equivalent, "strain_equivalent", "Equivalent strain", "", seq, 0, strain},
    {Field::strain_xx, "strain_xx", "Green strain xx", "", div, 0, strain},
    {Field::strain_yy, "strain_yy", "Green strain yy", "", div, 0, strain},
    {Field::strain_zz, "strain_zz", "Green strain zz", "", div, 0, strain, false, true},
    {Field::strain_xy, "strain_xy", "Green strain xy", "", div, 0, strain},
    {Field::strain_yz, "strain_yz", "Green strain yz", "", div, 0, strain, false, true},
    {Field::strain_xz, "strain_xz", "Green strain xz", "", div, 0, strain, false, true},
    {Field::stress_1, "stress_1", "Largest principal stress", "Pa", div, 0, stress},
    {Field::stress_2, "stress_2", "Middle principal stress", "Pa", div, 0, stress},
    {Field::stress_3, "stress_3", "Smallest principal stress", "Pa", div, 0, stress},
    {Field::shear, "shear", "Largest shear stress", "Pa", seq, 0, stress},
    {Field::stress_xx, "stress_xx", "Stress xx", "Pa", div, 0, stress},
    {Field::stress_yy, "stress_yy", "Stress yy", "Pa", div, 0, stress},
    {Field::stress_zz, "stress_zz", "Stress zz", "Pa", div, 0, stress},
    {Field::stress_xy, "stress_xy", "Stress xy", "Pa", div, 0, stress},
    {Field::stress_yz, "stress_yz", "Stress yz", "Pa", div, 0, stress, false, true},
    {Field::stress_xz, "stress_xz", "Stress xz", "Pa", div, 0, stress, false, true},
    {Field::node_mass, "node_mass", "Node mass", "kg", seq, 0, nodes, true},
    {Field::node_speed, "node_speed", "Node speed", "m/s", seq, 0, nodes, true},
    {Field::node_velocity_x, "node_velocity_x", "Node velocity x", "m/s", div, 0, nodes, true},
    {Field::node_velocity_y, "node_velocity_y", "Node velocity y", "m/s", div, 0, nodes, true},
    {Field::node_velocity_z, "node_velocity_z", "Node velocity z", "m/s", div, 0, nodes, true, true},
    {Field::node_displacement, "node_displacement", "Node displacement in the step", "m", seq, 0, nodes, true},
    {Field::node_force, "node_force", "Internal force on nodes", "N", seq, 0, nodes, true},
    {Field::node_force_x, "node_force_x", "Internal force x", "N", div, 0, nodes, true},
    {Field::node_force_y, "node_force_y", "Internal force y", "N", div, 0, nodes, true},
    {Field::node_force_z, "node_force_z", "Internal force z", "N", div, 0, nodes, true, true},
    {Field::node_residual, "node_residual", "Residual left at nodes", "N", seq, 0, nodes, true},
}};
// clang-format on

constexpr bool in_order() {
  for (std::size_t k = 0; k < table.size(); ++k)
    if (static_cast<std::size_t>(table[k].field) != k) return false;
  return true;
}
static_assert(in_order(), "the table follows the enumeration");
static_assert(field_count <= 64, "a request has a bit for each");

}  // namespace

std::span<const FieldInfo> fields() {
  return table;
}

const FieldInfo& field_info(Field field) {
  return table[static_cast<std::size_t>(field)];
}

const FieldInfo* find_field(std::string_view key) {
  for (const FieldInfo& f : table)
    if (f.key == key) return &f;
  return nullptr;
}

}  // namespace pf
