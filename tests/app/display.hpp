// A display for tests of the window: the one that is there, else an Xvfb of our own.
#pragma once

#include <string>

namespace pf::test {

/// Empty when a window can be opened; else why not. Starts Xvfb on the first call where that is needed.
std::string display_or_reason();

}  // namespace pf::test
