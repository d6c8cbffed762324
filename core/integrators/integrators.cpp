#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "core/integrators/backward_euler.hpp"
#include "core/integrators/generalized_alpha.hpp"
#include "core/integrators/implicit_midpoint.hpp"
#include "core/integrators/quasi_static.hpp"
#include "core/integrators/symplectic_euler.hpp"
#include "core/integrators/tr_bdf2.hpp"
#include "core/integrators/trapezoidal.hpp"

namespace pf {

namespace {
constexpr std::array<IntegratorInfo, 7> registry{{
    {"backward_euler", "Backward Euler", "Implicit: stable at any step; damps fast motion. First order.", true, true,
     true, 1},
    {"implicit_midpoint", "Implicit midpoint",
     "Implicit: keeps the energy of smooth motion, and waves too short for dt too; hard contact may add some. Second "
     "order.",
     true, true, false, 2},
    {"trapezoidal", "Trapezoidal rule", "Implicit: as midpoint, forces at both ends of the step. Second order.", true,
     true, false, 2},
    {"tr_bdf2", "TR-BDF2", "Implicit, two solves a step: damps only what dt cannot follow. Second order.", true, true,
     false, 2},
    {"generalized_alpha", "Generalised alpha", "Implicit: damps waves too short for dt as much as asked. Second order.",
     true, true, false, 2},
    {"symplectic_euler", "Symplectic Euler", "Explicit: cheapest where dt stays below dx/c; blows up above.", false,
     true, true, 1},
    {"quasi_static", "Quasi-static", "Equilibrium without inertia at every step: time is a load parameter.", true,
     false, false, 1},
}};
}  // namespace

std::span<const IntegratorInfo> integrators() {
  return registry;
}

const IntegratorInfo* find_integrator(std::string_view name) {
  const auto found =
      std::find_if(registry.begin(), registry.end(), [&](const IntegratorInfo& i) { return i.name == name; });
  return found == registry.end() ? nullptr : found;
}

template <int D>
std::unique_ptr<Integrator<D>> make_integrator(std::string_view name, double spectral_radius) {
  if (name == "backward_euler") return std::make_unique<BackwardEuler<D>>();
  if (name == "implicit_midpoint") return std::make_unique<ImplicitMidpoint<D>>();
  if (name == "trapezoidal") return std::make_unique<Trapezoidal<D>>();
  if (name == "tr_bdf2") return std::make_unique<TrBdf2<D>>();
  if (name == "generalized_alpha") return std::make_unique<GeneralizedAlpha<D>>(spectral_radius);
  if (name == "symplectic_euler") return std::make_unique<SymplecticEuler<D>>();
  if (name == "quasi_static") return std::make_unique<QuasiStatic<D>>();
  throw std::invalid_argument("unknown integrator " + std::string(name));
}

template std::unique_ptr<Integrator<2>> make_integrator<2>(std::string_view, double);
template std::unique_ptr<Integrator<3>> make_integrator<3>(std::string_view, double);

}  // namespace pf
