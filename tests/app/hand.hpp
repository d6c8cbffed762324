// A hand on the mouse of a staged window.
#pragma once

#include "tests/app/stage.hpp"

namespace pf::app::staged {

class Hand {
 public:
  explicit Hand(Stage& stage) : stage_(stage) {}

  void move(Point2 to) {
    at_.x = to.x;
    at_.y = to.y;
    show();
  }
  void press(int button = 0) { hold(button, true); }
  void release(int button = 0) { hold(button, false); }
  void click(Point2 where, int button = 0) {
    move(where);
    press(button);
    release(button);
  }
  void drag(Point2 from, Point2 to, int button = 0) {
    move(from);
    press(button);
    constexpr int pieces = 6;
    for (int k = 1; k <= pieces; ++k) {
      const float s = static_cast<float>(k) / pieces;
      move({from.x + s * (to.x - from.x), from.y + s * (to.y - from.y)});
    }
    release(button);
  }
  void wheel(float notches) {
    at_.wheel = notches;
    show();
    at_.wheel = 0;
  }
  void modifiers(bool shift, bool ctrl = false) {
    at_.shift = shift;
    at_.ctrl = ctrl;
  }

 private:
  void hold(int button, bool down) {
    at_.down[static_cast<std::size_t>(button)] = down;
    show();
  }
  /// Two frames: ImGui takes a press where the mouse was a frame ago.
  void show() {
    for (int k = 0; k < 2; ++k) {
      stage_->feed(at_);
      const long before = stage_->frames_drawn();
      REQUIRE(stage_.until([&] { return stage_->frames_drawn() > before; }));
      at_.wheel = 0;
    }
  }

  Stage& stage_;
  GlfwWindow::Pointer at_{};
};

/// Where the window shows this place.
inline Point2 at(Stage& stage, const Vec3& where) {
  const auto pixel = stage->view().to_window(where);
  REQUIRE(pixel);
  return *pixel;
}

/// Turns the loop until the last edit has reached the simulation.
inline bool applied(Stage& stage) {
  stage.frames(1);
  return stage.until([&] {
    const SessionStatus& s = stage.context().status;
    return s.edit.applies_at_step < 0 && s.state != RunState::loading && !s.step_in_flight;
  });
}

/// Presses the key and turns the loop.
inline void key(Stage& stage, Action action, int index = 0) {
  stage->act(action, index);
  stage.frames(2);
}

}  // namespace pf::app::staged
