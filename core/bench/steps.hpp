// Whole steps of small scenes, explicit and implicit.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/step_report.hpp"

namespace pf::bench {

struct StepResult {
  int dimension = 3;
  std::string basis, name;
  std::size_t particles = 0;
  int threads = 1, steps = 0;
  double ns = 0, least_ns = 0;    ///< a particle and step: median and least
  double newton = 0, linear = 0;  ///< iterations a step, mean
  std::string solver;             ///< what "auto" chose, and why
  PhaseTimes ms;                  ///< mean of the steps
};

/// A block of rubber (neo-Hookean, APIC) that is thrown and turns: symplectic Euler at a third of the stable step.
StepResult measure_explicit_step(int dimension, std::string_view basis, std::size_t about_particles, int threads,
                                 int steps);
/// A bar held at one end under gravity, E = 1e5 Pa, dt = 0.01 s: backward Euler.
StepResult measure_implicit_step(int dimension, std::string_view basis, std::size_t about_particles, int threads,
                                 int steps);

}  // namespace pf::bench
