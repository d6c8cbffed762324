// Edits of a scene that is being simulated.
#pragma once

#include <span>

#include "core/scene/scene_io.hpp"

namespace pf {

/// edited(), but its events stay as they are, unchecked: they were checked against the scene as the run began, and may
/// have been applied since, bodies that they bring in included. Throws InputError.
inline Scene edited_live(const Scene& scene, std::span<const Edit> edits) {
  Scene without = scene;
  without.events.clear();
  Scene next = edited(without, edits);
  next.events = scene.events;
  return next;
}

}  // namespace pf
