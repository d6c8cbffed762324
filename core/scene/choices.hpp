// The names that a scene may choose from: what parses, what is listed, what a combo offers. A name stands here
// only once it is built.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pf {

struct Choice {
  std::string_view name;   ///< as in the scene file
  std::string_view label;  ///< plain name
  std::string_view help;   ///< one line: when to choose it
};

std::span<const Choice> basis_choices();
std::span<const Choice> integrator_choices();
std::span<const Choice> transfer_choices();
std::span<const Choice> solver_choices();
std::span<const Choice> mass_choices();  ///< of the inertia and of the velocity transfer
std::span<const Choice> sampling_choices();
std::span<const Choice> contact_choices();
std::span<const Choice> step_control_choices();
std::span<const Choice> stroke_choices();
std::span<const Choice> shape_choices();

/// nullptr when no choice has this name.
const Choice* find_choice(std::span<const Choice> choices, std::string_view name);
std::vector<std::string> names(std::span<const Choice> choices);

}  // namespace pf
