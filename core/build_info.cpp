// The definitions come from cmake/build_info.cmake.
#include "core/build_info.hpp"

namespace pf {

namespace detail {
extern const char* const commit;  // commit.cpp, written when the program is built
}

BuildInfo build_info() {
  return {PUSHFORWARD_VERSION, detail::commit, PUSHFORWARD_COMPILER, PUSHFORWARD_FLAGS};
}

}  // namespace pf
