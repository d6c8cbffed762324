#include "core/materials/linear_elastic.hpp"

namespace pf {

LawInfo LinearElastic::info() {
  return {.name = "linear_elastic",
          .label = "Linear elastic",
          .about =
              "Small-strain elasticity, for comparison with textbook formulae. It is not objective: a body that "
              "turns swells and feels stress. psi = mu e:e + lambda/2 tr(e)^2, e = sym(F - I).",
          .parameters = isotropic_parameters(),
          .objective = false,
          .barrier_at_zero = false};
}

}  // namespace pf
