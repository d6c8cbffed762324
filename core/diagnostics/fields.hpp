// The particle fields that can be drawn, picked and exported: one table.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace pf {

enum class Field : std::uint8_t { speed, J, von_mises, pressure, energy_density, material, error };
inline constexpr int field_count = 7;

enum class FieldScale { sequential, diverging, categorical };

struct FieldInfo {
  Field field;
  std::string_view key;    ///< as in view.color_by
  std::string_view label;  ///< plain name
  std::string_view unit;   ///< SI
  FieldScale scale;
  double centre;  ///< of a diverging map
};

std::span<const FieldInfo> fields();
const FieldInfo& field_info(Field field);
const FieldInfo* find_field(std::string_view key);

}  // namespace pf
