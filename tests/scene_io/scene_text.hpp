// Small scenes for tests, and what is wrong with them.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene_io.hpp"

namespace pf {

/// The smallest scene: a box of rubber.
inline nlohmann::ordered_json small_scene(int dimension = 2) {
  using Json = nlohmann::ordered_json;
  const Json low = dimension == 2 ? Json{0, 0} : Json{0, 0, 0}, high = dimension == 2 ? Json{1, 1} : Json{1, 1, 1};
  return {
      {"dimension", dimension},
      {"grid", {{"spacing", 0.1}}},
      {"materials", {{"rubber", {{"model", "neo_hookean"}, {"density", 1000}, {"young", 1e5}, {"poisson", 0.3}}}}},
      {"bodies", Json::array({{{"material", "rubber"}, {"shape", {{"type", "box"}, {"min", low}, {"max", high}}}}})}};
}

/// One of everything that a scene may hold.
inline nlohmann::ordered_json full_scene() {
  return nlohmann::ordered_json::parse(R"json({
    "format": "pushforward/scene", "version": 1, "name": "All", "about": "One of everything.", "dimension": 2,
    "constants": {"A": 0.5, "c": 2}, "gravity": [0, -9.81], "body_force": ["A*sin(X)", 0],
    "grid": {"spacing": 0.05, "basis": "cubic"},
    "time": {"end": 2, "step": 0.01, "frame": 0.02, "control": "fixed"},
    "integrator": {"type": "backward_euler", "mass": "consistent"},
    "transfer": {"type": "flip", "flip_ratio": 0.9, "velocity_mass": "lumped"},
    "solver": {"newton_tolerance": 1e-8, "max_newton": 20, "linear": "direct"},
    "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
    "bodies": [{"name": "block", "material": "rubber", "velocity": ["-Y", "X"], "particles_per_axis": 3,
                "sampling": "jittered", "seed": 7,
                "shape": {"type": "difference", "scale": 2, "rotate": 30, "translate": [1, 0], "of": [
                  {"type": "polygon", "points": [[0, 0], [1, 0], [0, 1]]},
                  {"type": "ball", "center": [0.1, 0.1], "radius": 0.05},
                  {"type": "where", "expression": "X*Y - 0.2", "min": [0, 0], "max": [1, 1]}]}}],
    "boundaries": [{"shape": {"type": "half_space", "point": [0, -1], "normal": [0, 1]}, "invert": false,
                    "contact": "slip", "friction": 0.2, "velocity": ["sin(t)", 0]}],
    "constraints": [{"region": {"type": "box", "min": [0, 0], "max": [0, 1]}, "fix": [true, false], "velocity": ["A*t", 0]}],
    "loads": [{"body": "block", "region": {"type": "box", "min": [1, 0], "max": [1, 1]}, "traction": [0, "-min(t, 1)"]}],
    "probes": [{"name": "tip", "at": [1, 1]}],
    "events": [{"time": 1, "set": {"/transfer/flip_ratio": 0},
                "strokes": [{"kind": "paint", "material": "rubber", "shape": {"type": "ball", "center": [0, 0], "radius": 0.1}}]}],
    "view": {"color_by": "J"}
  })json");
}

/// What is wrong with it; nothing when it is a scene.
inline std::vector<Problem> problems_of(const std::string& text, const std::vector<Edit>& edits = {}) {
  try {
    parse_scene(text, "test", edits);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}
inline std::vector<Problem> problems_in(const nlohmann::ordered_json& scene) {
  return problems_of(scene.dump());
}

/// Is there a problem at this pointer?
inline bool has_problem(const std::vector<Problem>& problems, const std::string& pointer) {
  for (const Problem& problem : problems) {
    if (problem.pointer == pointer && !problem.found.empty() && !problem.allowed.empty()) return true;
  }
  return false;
}
inline std::string list(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) text += to_string(problem) + "\n";
  return text;
}

}  // namespace pf
