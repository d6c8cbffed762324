// The bar under the view while a step is played slowly.
#pragma once

#include "app/context.hpp"

namespace pf::app {

/// Fills the current window; the choices stand `below` the bar where they do not fit beside it: there. False once the
/// user has closed it.
bool draw_scrubber(AppContext& context, float below);

}  // namespace pf::app
