// What a particle's square or ball is mapped by: F, and before it the shape that the particle had at first, where that
// was no cube (Snapshot::domain).
#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "core/snapshot.hpp"

namespace pf {

/// Side of a cube as large as the particle at first [m].
inline float side_of(const Snapshot& s, std::size_t p) {
  if (p >= s.volume0.size()) return 0.5f * static_cast<float>(s.spacing);
  return s.dimension == 2 ? std::sqrt(s.volume0[p]) : std::cbrt(s.volume0[p]);
}
/// What maps that cube's axes, columns; `F` the deformation gradient.
inline glm::mat2 mapped_by(const Snapshot& s, std::size_t p, const glm::mat2& F) {
  const float* const e = p < s.id.size() ? s.domain_of(s.id[p]) : nullptr;
  return e ? F * glm::mat2(e[0], e[1], e[2], e[3]) / side_of(s, p) : F;
}
inline glm::mat3 mapped_by(const Snapshot& s, std::size_t p, const glm::mat3& F) {
  const float* const e = p < s.id.size() ? s.domain_of(s.id[p]) : nullptr;
  return e ? F * glm::mat3(e[0], e[1], e[2], e[3], e[4], e[5], e[6], e[7], e[8]) / side_of(s, p) : F;
}

}  // namespace pf
