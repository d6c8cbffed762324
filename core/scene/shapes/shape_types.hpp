// The registry of shapes: what a scene may ask for, what each must be given, and how it is made.
#pragma once

#include <initializer_list>
#include <span>
#include <string_view>

#include "core/scene/shapes/shape_solid.hpp"

namespace pf {

/// What a shape is made from besides its own keys.
struct ShapeContext {
  int dimension;
  const Constants& constants;
  /// Makes the members of a boolean, one level deeper.
  std::vector<SolidPointer> (*members)(const Shape& shape, const ShapeContext& context);
  int nesting;
};

struct ShapeType {
  std::string_view name;                   ///< as in the scene file
  std::string_view label;                  ///< plain name
  std::string_view help;                   ///< one line
  int dimension;                           ///< the only one in which it exists; 0: both
  std::span<const std::string_view> keys;  ///< that it must be given, besides "type"
  SolidPointer (*make)(const Shape& shape, const ShapeContext& context);
};

/// In the order in which they are offered.
std::span<const ShapeType> shape_types();
/// Null for an unknown name.
const ShapeType* find_shape_type(std::string_view name);

}  // namespace pf
