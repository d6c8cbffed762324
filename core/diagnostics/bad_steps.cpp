#include "core/diagnostics/bad_steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pf {
namespace {

constexpr double nearly_inverted = 0.1;
/// A jump of the energy: so much of what the bodies have, and so many times what the steps before changed it by.
constexpr double jump_part = 0.02, jump_factor = 20;
constexpr std::size_t steps_before = 8;

std::string text(const char* format, double a) {
  char line[160];
  std::snprintf(line, sizeof line, format, a);
  return line;
}

std::optional<std::string> energy_jump(std::span<const StepReport> reports) {
  if (reports.size() < steps_before + 2) return std::nullopt;
  const auto change = [&](std::size_t back) {
    const std::size_t k = reports.size() - 1 - back;
    return reports[k].balance.total() - reports[k - 1].balance.total();
  };
  const double jump = change(0);
  double usual = 0;
  for (std::size_t back = 1; back <= steps_before; ++back) usual = std::max(usual, std::abs(change(back)));
  const Balance& now = reports.back().balance;
  if (!(jump > jump_part * (std::abs(now.kinetic) + std::abs(now.elastic))) || !(jump > jump_factor * usual))
    return std::nullopt;
  return text("The total energy rose by %.3g J within this step.", jump);
}

}  // namespace

std::optional<BadStep> bad_step(std::span<const StepReport> reports, double tolerance) {
  if (reports.empty()) return std::nullopt;
  const StepReport& last = reports.back();
  if (last.retries > 0) {
    std::string why = "The step had to be begun again with a smaller dt.";
    // Without the "Step 12 at t = 0.1 s: " that stands in front of it.
    if (!last.warnings.empty()) {
      const std::string& told = last.warnings.front();
      const auto colon = told.find(": ");
      why = told.starts_with("Step ") && colon != std::string::npos ? told.substr(colon + 2) : told;
    }
    return BadStep{last.step, why};
  }
  if (last.residual > tolerance)
    return BadStep{last.step, text("Newton's method left a relative residual of %.2g.", last.residual)};
  const bool was = reports.size() > 1 && reports[reports.size() - 2].min_J < nearly_inverted;
  if (last.min_J < nearly_inverted && !was)
    return BadStep{last.step, text("A particle is squeezed to %.2g of its volume, nearly inside out.", last.min_J)};
  if (const auto jump = energy_jump(reports)) return BadStep{last.step, *jump};
  return std::nullopt;
}

}  // namespace pf
