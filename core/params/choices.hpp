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

std::span<const Choice> bases();
std::span<const Choice> integrators();
std::span<const Choice> transfers();
std::span<const Choice> linear_solvers();
std::span<const Choice> masses();  ///< of the inertia and of the velocity transfer
std::span<const Choice> samplings();
std::span<const Choice> contacts();
std::span<const Choice> step_controls();
std::span<const Choice> shapes();

/// nullptr when no choice has this name.
const Choice* find_choice(std::span<const Choice> choices, std::string_view name);
std::vector<std::string> names(std::span<const Choice> choices);

}  // namespace pf
