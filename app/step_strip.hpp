// The strip under the time line: how long adaptive steps were, explicit or implicit, and why.
#pragma once

#include "app/context.hpp"
#include "app/layout.hpp"

namespace pf::app {

/// Whether there is something to show: the scene's steps are adaptive.
bool has_step_strip(const AppContext& context);
/// Into the current window, at this place of the screen.
void draw_step_strip(const AppContext& context, const Rect& place);
/// "stable no longer than this", ...: what decided the length of a step, for people.
const char* reason_of(StepLimit limit);

}  // namespace pf::app
