#include "core/scene/choices.hpp"

#include "core/bases/basis.hpp"
#include "core/control/step_control.hpp"
#include "core/integrators/integrator.hpp"
#include "core/scene/shapes/shape_types.hpp"
#include "core/solvers/linear_solver.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {
namespace {

/// The registries of the numerics, as choices: their tables are the only place that names what is built.
template <class Registry>
std::vector<Choice> choices_of(const Registry& registry) {
  std::vector<Choice> choices;
  for (const auto& entry : registry) choices.push_back({entry.name, entry.label, entry.about});
  return choices;
}

constexpr Choice mass_table[] = {
    {"lumped", "Lumped", "row sums: diagonal, positive wherever there is mass"},
    {"consistent", "Consistent", "the full matrix: more accurate, may be nearly singular at edges"},
};
constexpr Choice sampling_table[] = {
    {"lattice", "Lattice", "regular, aligned with the grid: most accurate at the start"},
    {"fitted", "Fitted to the surface",
     "lattice cells cut by the surface: the body's edge is no staircase, particles there are smaller"},
    {"jittered", "Jittered", "lattice points moved at random (seed): no preferred direction"},
    {"poisson_disc", "Poisson disc", "random with a least distance (seed): even and irregular"},
};
constexpr Choice contact_table[] = {
    {"stick", "Stick", "material that touches moves with the boundary"},
    {"slip", "Slip", "slides along the boundary, never leaves it"},
    {"separate", "Separate", "may leave the boundary, never enters it"},
};
constexpr Choice stroke_table[] = {
    {"cut", "Cut", "takes the particles away"},
    {"paint", "Paint", "gives the particles another material; what they are deformed by stays"},
};

}  // namespace

std::span<const Choice> basis_choices() {
  static const std::vector<Choice> choices = choices_of(bases());
  return choices;
}
std::span<const Choice> integrator_choices() {
  static const std::vector<Choice> choices = choices_of(integrators());
  return choices;
}
std::span<const Choice> transfer_choices() {
  static const std::vector<Choice> choices = choices_of(transfers());
  return choices;
}
std::span<const Choice> solver_choices() {
  static const std::vector<Choice> choices = choices_of(linear_solvers());
  return choices;
}
std::span<const Choice> mass_choices() {
  return mass_table;
}
std::span<const Choice> sampling_choices() {
  return sampling_table;
}
std::span<const Choice> contact_choices() {
  return contact_table;
}
std::span<const Choice> stroke_choices() {
  return stroke_table;
}
std::span<const Choice> step_control_choices() {
  static const std::vector<Choice> choices = choices_of(step_controls());
  return choices;
}
std::span<const Choice> shape_choices() {
  static const std::vector<Choice> choices = [] {
    std::vector<Choice> list;
    for (const ShapeType& type : shape_types()) list.push_back({type.name, type.label, type.help});
    return list;
  }();
  return choices;
}

const Choice* find_choice(std::span<const Choice> choices, std::string_view name) {
  for (const Choice& choice : choices) {
    if (choice.name == name) return &choice;
  }
  return nullptr;
}

std::vector<std::string> names(std::span<const Choice> choices) {
  std::vector<std::string> result;
  for (const Choice& choice : choices) result.emplace_back(choice.name);
  return result;
}

}  // namespace pf
