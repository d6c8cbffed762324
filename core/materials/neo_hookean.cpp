#include "core/materials/neo_hookean.hpp"

namespace pf {

LawInfo NeoHookean::info() {
  return {.name = "neo_hookean",
          .label = "Neo-Hookean",
          .about =
              "Rubber-like solid for large strain; the energy grows without bound as a particle is crushed, so it "
              "never inverts. psi = mu/2 (tr F^T F - 3) - mu ln J + lambda/2 ln^2 J (Bonet and Wood 2008).",
          .parameters = isotropic_parameters(),
          .objective = true,
          .barrier_at_zero = true};
}

}  // namespace pf
