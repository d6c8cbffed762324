// A study small enough to run many times in a test: a bar of 32 particles.
#pragma once

#include <string>
#include <vector>

#include "core/params/problem.hpp"
#include "core/studies/study_io.hpp"

namespace pf::test {

inline const char* const bar_scene = R"json({
  "dimension": 2, "constants": {"A": 0.01, "w": 15.707963267948966},
  "grid": {"spacing": 0.125}, "time": {"end": 0.08, "step": 0.004},
  "transfer": {"type": "flip", "flip_ratio": 1},
  "materials": {"bar": {"model": "linear_elastic", "density": 1000, "young": 1e5, "poisson": 0}},
  "bodies": [{"material": "bar", "shape": {"type": "box", "min": [0, 0], "max": [1, 0.125]}}],
  "constraints": [{"region": {"type": "box", "min": [-1, -1], "max": [0, 2]}, "fix": [true, false]},
                  {"region": {"type": "box", "min": [-1, -1], "max": [2, 2]}, "fix": [false, true]}],
  "exact": {"position": ["X + A*sin(w*t)*sin(pi*X/2)", "Y"]}
})json";

/// `members`: what follows the scene, without the last brace.
inline std::string study_text(const std::string& members) {
  return std::string(R"({"name": "Small", "scene": )") + bar_scene + ", " + members + "}";
}
inline Study small_study(const std::string& members) {
  return parse_study(study_text(members), "test.json", ".");
}
inline std::vector<Problem> study_problems(const std::string& text) {
  try {
    parse_study(text, "test.json", ".");
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

}  // namespace pf::test
