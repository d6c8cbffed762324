#include <array>
#include <stdexcept>
#include <string>

#include "core/integrators/backward_euler.hpp"
#include "core/integrators/symplectic_euler.hpp"

namespace pf {

namespace {
constexpr std::array<IntegratorInfo, 2> registry{{
    {"backward_euler", "Backward Euler", "Implicit: stable at any step; damps fast motion. First order.", true},
    {"symplectic_euler", "Symplectic Euler", "Explicit: cheapest where dt stays below dx/c; blows up above.", false},
}};
}  // namespace

std::span<const IntegratorInfo> integrators() {
  return registry;
}

template <int D>
std::unique_ptr<Integrator<D>> make_integrator(std::string_view name) {
  if (name == "backward_euler") return std::make_unique<BackwardEuler<D>>();
  if (name == "symplectic_euler") return std::make_unique<SymplecticEuler<D>>();
  throw std::invalid_argument("unknown integrator " + std::string(name));
}

template std::unique_ptr<Integrator<2>> make_integrator<2>(std::string_view);
template std::unique_ptr<Integrator<3>> make_integrator<3>(std::string_view);

}  // namespace pf
