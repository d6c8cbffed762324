#include "core/materials/fixed_corotated.hpp"

namespace pf {

LawInfo FixedCorotated::info() {
  return {.name = "fixed_corotated",
          .label = "Fixed corotated",
          .about =
              "The usual law of computer graphics: linear in the stretches, robust, and finite when crushed, so "
              "that particles can invert. psi = mu sum (s - 1)^2 + lambda/2 (J - 1)^2 (Stomakhin et al. 2012).",
          .parameters = isotropic_parameters(),
          .objective = true,
          .barrier_at_zero = false};
}

}  // namespace pf
