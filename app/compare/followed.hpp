// One particle in all lanes: selected by a click in any of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compare/desk.hpp"

namespace pf::app {

/// The particle in one lane; nothing where that lane has none of this id.
struct FollowedParticle {
  Vec3 x = Vec3::Zero();        ///< [m]
  double J = 1;                 ///< det F
  std::optional<double> value;  ///< of the field that is shown, in its unit
  std::optional<double> apart;  ///< from where lane 1 has it [m]
};
std::vector<std::optional<FollowedParticle>> followed(const ComparisonFrame& frame, std::uint32_t id, Field field);

/// A row a lane, while a particle is selected. Inside of ImGui's frame.
void draw_followed(AppContext& context, const CompareDesk& desk);

}  // namespace pf::app
