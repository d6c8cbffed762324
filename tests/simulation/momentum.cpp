// What must always hold (THEORY T6), over the registries, in 2D and 3D.
#include <doctest/doctest.h>

#include "core/bases/basis.hpp"
#include "core/scene/scene_io.hpp"
#include "core/simulation.hpp"
#include "core/transfers/transfer.hpp"

using namespace pf;

namespace {

/// A block of rubber in free flight, turning.
Scene flying_block(int dimension, std::string_view basis, std::string_view transfer) {
  const std::string z = dimension == 3 ? ", 0.1" : "", Z = dimension == 3 ? ", 0.5" : "";
  const std::string text = R"({"dimension": )" + std::to_string(dimension) +
                           R"(, "grid": {"spacing": 0.1, "basis": ")" + std::string(basis) +
                           R"("}, "time": {"end": 0.1, "step": 0.01}, "transfer": {"type": ")" + std::string(transfer) +
                           R"("},
      "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
      "bodies": [{"name": "block", "material": "rubber", "velocity": ["1 - 2*Y", "0.5 + 2*X")" +
                           (dimension == 3 ? R"(, "0.3")" : "") + R"(], "shape": {"type": "box", "min": [0.1, 0.2)" +
                           z + R"(], "max": [0.5, 0.6)" + Z + "]}}]}";
  return parse_scene(text, "flying block");
}

}  // namespace

TEST_CASE("a free body keeps its mass and linear momentum under every basis and transfer") {
  for (const int dimension : {2, 3})
    for (const BasisInfo& basis : bases())
      for (const TransferInfo& transfer : transfers()) {
        CAPTURE(dimension);
        CAPTURE(basis.name);
        CAPTURE(transfer.name);
        const auto simulation = make_simulation(flying_block(dimension, basis.name, transfer.name));
        const Vec3 before = simulation->report().balance.momentum;
        for (int k = 0; k < 10; ++k) REQUIRE(simulation->step().status == StepStatus::accepted);
        CHECK((simulation->report().balance.momentum - before).norm() < 1e-6 * before.norm());
      }
}
