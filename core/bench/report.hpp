// The measurements as a table for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/bench/kernels.hpp"
#include "core/bench/machine.hpp"
#include "core/bench/steps.hpp"

namespace pf::bench {

std::string text(const Machine& machine);
std::string text(const Machine& machine, const KernelCase& measured);
std::string step_heading();
std::string text(const StepResult& measured);

nlohmann::ordered_json to_json(const Machine& machine);
nlohmann::ordered_json to_json(const Machine& machine, const KernelCase& measured);
nlohmann::ordered_json to_json(const StepResult& measured);

/// Nanoseconds a particle that the machine needs at least: to move the bytes or to do the flops, whichever takes
/// longer.
double roofline_ns(const Machine& machine, const Counts& counts, int threads);

}  // namespace pf::bench
