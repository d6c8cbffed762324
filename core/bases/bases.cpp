#include <array>

#include "core/bases/basis.hpp"
#include "core/bases/cubic.hpp"
#include "core/bases/gimp.hpp"
#include "core/bases/linear.hpp"
#include "core/bases/quadratic.hpp"
#include "core/bases/quadratic_gimp.hpp"

namespace pf {

namespace {
constexpr std::array registry{linear_basis, quadratic_basis, cubic_basis, gimp_basis, quadratic_gimp_basis};
}  // namespace

std::span<const BasisInfo> bases() {
  return registry;
}

const BasisInfo* find_basis(std::string_view name) {
  for (const BasisInfo& basis : registry)
    if (basis.name == name) return &basis;
  return nullptr;
}

}  // namespace pf
