#include "core/scene/shapes/shape_types.hpp"

#include <algorithm>
#include <stdexcept>

namespace pf {
namespace {

using Keys = std::string_view;
constexpr Keys corners[] = {"min", "max"}, ball[] = {"center", "radius"}, cylinder[] = {"from", "to", "radius"},
               polygon[] = {"points"}, half_space[] = {"point", "normal"}, where[] = {"expression", "min", "max"},
               members[] = {"of"};

using Context = const ShapeContext&;

/// Every shape: one entry a type.
constexpr ShapeType types[] = {
    {"box", "Box", "between two corners", 0, corners,
     [](const Shape& s, Context c) { return make_box(s, c.dimension); }},
    {"ball", "Ball", "a disc in 2D", 0, ball, [](const Shape& s, Context c) { return make_ball(s, c.dimension); }},
    {"cylinder", "Cylinder", "round, between the centres of its two ends; 3D", 3, cylinder,
     [](const Shape& s, Context) { return make_cylinder(s); }},
    {"polygon", "Polygon", "closed by itself, must not cross itself; 2D", 2, polygon,
     [](const Shape& s, Context) {
       if (s.points.empty()) throw std::invalid_argument("a polygon needs points");
       return make_polygon(s);
     }},
    {"half_space", "Half space", "everything behind a plane (3D) or a line (2D); normal points out of it", 0,
     half_space, [](const Shape& s, Context c) { return make_half_space(s, c.dimension); }},
    {"where", "Where", "all points between two corners where an expression in X Y Z is positive", 0, where,
     [](const Shape& s, Context c) { return make_where(s, c.dimension, c.constants); }},
    {"union", "Union", "what is in any of several shapes", 0, members,
     [](const Shape& s, Context c) { return make_union(c.members(s, c), c.dimension); }},
    {"difference", "Difference", "the first shape without the others", 0, members,
     [](const Shape& s, Context c) { return make_difference(c.members(s, c), c.dimension); }},
    {"intersection", "Intersection", "what is in all of several shapes", 0, members,
     [](const Shape& s, Context c) { return make_intersection(c.members(s, c), c.dimension); }},
};

}  // namespace

std::span<const ShapeType> shape_types() {
  return types;
}

const ShapeType* find_shape_type(std::string_view name) {
  const auto found = std::ranges::find(types, name, &ShapeType::name);
  return found == std::end(types) ? nullptr : found;
}

}  // namespace pf
