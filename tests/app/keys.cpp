#include "app/keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

using namespace pf::app;

TEST_CASE("keys mean what the design says") {
  const auto means = [](int key, int mods, Action action, int index = 0) {
    const auto press = find_key(key, mods);
    REQUIRE(press);
    CHECK(press->action == action);
    CHECK(press->index == index);
  };
  means(GLFW_KEY_SPACE, 0, Action::run_pause);
  means(GLFW_KEY_RIGHT, 0, Action::step);
  means(GLFW_KEY_R, 0, Action::reset);
  means(GLFW_KEY_LEFT, 0, Action::step_back);
  means(GLFW_KEY_B, 0, Action::bad_step);
  means(GLFW_KEY_F, 0, Action::fit);
  means(GLFW_KEY_G, 0, Action::grid);
  means(GLFW_KEY_V, 0, Action::vectors);
  means(GLFW_KEY_1, 0, Action::field, 0);
  means(GLFW_KEY_9, 0, Action::field, 8);
  means(GLFW_KEY_TAB, 0, Action::hide_panels);
  means(GLFW_KEY_F1, 0, Action::help);
  means(GLFW_KEY_F11, 0, Action::full_screen);
  means(GLFW_KEY_F12, 0, Action::picture);
  means(GLFW_KEY_ESCAPE, 0, Action::deselect);
  CHECK_FALSE(find_key(GLFW_KEY_R, GLFW_MOD_ALT));
  CHECK_FALSE(find_key(GLFW_KEY_Q, 0));
  means(GLFW_KEY_SPACE, GLFW_MOD_NUM_LOCK | GLFW_MOD_CAPS_LOCK, Action::run_pause);
#ifndef __APPLE__
  means(GLFW_KEY_O, GLFW_MOD_CONTROL, Action::open);
  means(GLFW_KEY_S, GLFW_MOD_CONTROL, Action::save);
  means(GLFW_KEY_S, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT, Action::save_as);
  means(GLFW_KEY_Z, GLFW_MOD_CONTROL, Action::undo);
  means(GLFW_KEY_Z, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT, Action::redo);
#endif
}

TEST_CASE("no two actions share a key and every action has one row") {
  for (const KeyBinding& a : key_bindings()) {
    CHECK(&binding(a.action) == &a);
    for (const KeyBinding& b : key_bindings()) {
      if (&a == &b || a.key == 0 || b.key == 0 || a.mods != b.mods) continue;
      CHECK((a.key + a.keys <= b.key || b.key + b.keys <= a.key));
    }
  }
}
