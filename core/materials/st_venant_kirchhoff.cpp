#include "core/materials/st_venant_kirchhoff.hpp"

namespace pf {

LawInfo StVenantKirchhoff::info() {
  return {.name = "st_venant_kirchhoff",
          .label = "Saint Venant-Kirchhoff",
          .about =
              "Linear between Green strain and second Piola-Kirchhoff stress: large rotation with small strain. It "
              "softens and then collapses in compression (below about 58 % of its length), without resistance to "
              "inversion. psi = mu E:E + lambda/2 tr(E)^2, E = (F^T F - I)/2.",
          .parameters = isotropic_parameters(),
          .objective = true,
          .barrier_at_zero = false};
}

}  // namespace pf
