#pragma once

#include <filesystem>
#include <string>

#include "core/files.hpp"
#include "core/scene/scene_io.hpp"
#include "tests/temporary_folder.hpp"

namespace pf::test {

/// A small valid scene: 2 s in steps of 0.1 s; `extra` is JSON text of more members, each with a comma in front.
inline Scene small_scene(int dimension = 2, const std::string& extra = "") {
  const std::string corner = dimension == 2 ? "[1, 1]" : "[1, 1, 1]", origin = dimension == 2 ? "[0, 0]" : "[0, 0, 0]";
  return parse_scene(R"({"name": "Flight", "dimension": )" + std::to_string(dimension) +
                         R"(, "grid": {"spacing": 0.5},
                             "materials": {"rubber": {"model": "neo_hookean", "density": 8, "young": 1e5, "poisson": 0.3}},
                             "bodies": [{"name": "block", "material": "rubber",
                                         "shape": {"type": "box", "min": )" +
                         origin + R"(, "max": )" + corner + "}}]" + extra + "}",
                     "test");
}

/// Settings of time as a member for small_scene.
inline std::string time_member(double end, double step, double frame) {
  return ", \"time\": {\"end\": " + std::to_string(end) + ", \"step\": " + std::to_string(step) +
         ", \"frame\": " + std::to_string(frame) + "}";
}

}  // namespace pf::test
