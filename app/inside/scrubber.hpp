// The bar under the view while a step is played slowly.
#pragma once

#include "app/context.hpp"

namespace pf::app {

/// Fills the current window. False once the user has closed it.
bool draw_scrubber(AppContext& context);

}  // namespace pf::app
