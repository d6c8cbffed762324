// Runs panels in ImGui without a window or a graphics card.
#pragma once

#include <imgui.h>

#include <functional>
#include <vector>

#include "app/context.hpp"
#include "app/theme.hpp"
#include "tests/panels/letters.hpp"

namespace pf::app {

/// A 2D scene with everything that the panels can show: two materials, two bodies, a wall.
Scene rich_scene();
/// A 3D scene with little in it.
Scene plain_scene();
/// A run of `steps` made-up steps, so that the plots have something to draw.
std::vector<StepReport> made_up_reports(int steps);

/// Puts the scene, a snapshot, a run and actions that work on `context` alone into it.
void fill(AppContext& context, const Scene& scene);

/// One ImGui context, the session it talks to and the context of the panels.
class Harness {
 public:
  explicit Harness(const Scene& scene, Theme theme = Theme::dark, float scale = 1);
  ~Harness();
  Harness(const Harness&) = delete;
  Harness& operator=(const Harness&) = delete;

  /// Draws one frame with `draw` in a window of this size at 0, 0 and returns its letters.
  std::vector<Letter> frame(ImVec2 size, const std::function<void(AppContext&)>& draw);
  /// The same several times: layouts settle in the second frame.
  std::vector<Letter> settle(ImVec2 size, const std::function<void(AppContext&)>& draw);

  Session session;
  AppContext context;
};

}  // namespace pf::app
