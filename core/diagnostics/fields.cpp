#include "core/diagnostics/fields.hpp"

#include <array>

namespace pf {

namespace {
constexpr std::array<FieldInfo, field_count> table{{
    {Field::speed, "speed", "Speed", "m/s", FieldScale::sequential, 0},
    {Field::J, "J", "Volume ratio J", "", FieldScale::diverging, 1},
    {Field::von_mises, "von_mises", "von Mises stress", "Pa", FieldScale::sequential, 0},
    {Field::pressure, "pressure", "Pressure", "Pa", FieldScale::diverging, 0},
    {Field::energy_density, "energy_density", "Energy density", "J/m\xc2\xb3", FieldScale::sequential, 0},
    {Field::material, "material", "Material", "", FieldScale::categorical, 0},
    {Field::error, "error", "Displacement error", "m", FieldScale::sequential, 0},
}};
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
