#include "core/materials/hencky.hpp"

namespace pf {

LawInfo Hencky::info() {
  return {.name = "hencky",
          .label = "Hencky",
          .about =
              "Linear between Kirchhoff stress and logarithmic strain: true stress and strain of metals and soils "
              "at moderate strain, and the base of plastic laws. psi = mu sum ln^2 s + lambda/2 ln^2 J "
              "(Hencky 1928).",
          .parameters = isotropic_parameters(),
          .objective = true,
          .barrier_at_zero = true};
}

}  // namespace pf
