// Which lists of a scene may grow, and which may be replaced, while it is being simulated.
#pragma once

#include <string_view>

namespace pf {

/// Whether an edit at `pointer` lets something enter a running simulation, or leave it: bodies enter; walls enter at
/// the end of their list and leave from there; constraints and probes come and go as one likes.
inline bool comes_or_goes_live(std::string_view pointer) {
  for (const std::string_view list :
       {"/bodies/-", "/boundaries/-", "/boundaries", "/constraints/-", "/constraints", "/probes/-", "/probes"})
    if (pointer == list) return true;
  return false;
}

}  // namespace pf
