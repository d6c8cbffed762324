#include "app/keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <cstdlib>

namespace pf::app {
namespace {

#ifdef __APPLE__
#define PF_CTRL "Cmd"
constexpr int ctrl = GLFW_MOD_SUPER;
#else
#define PF_CTRL "Ctrl"
constexpr int ctrl = GLFW_MOD_CONTROL;
#endif
constexpr int shift = GLFW_MOD_SHIFT;

// clang-format off
constexpr std::array bindings{
    KeyBinding{Action::open, GLFW_KEY_O, ctrl, 1, PF_CTRL "+O", "Open…", "File"},
    KeyBinding{Action::save, GLFW_KEY_S, ctrl, 1, PF_CTRL "+S", "Save", "File"},
    KeyBinding{Action::save_as, GLFW_KEY_S, ctrl | shift, 1, PF_CTRL "+Shift+S", "Save as…", "File"},
    KeyBinding{Action::save_recording, 0, 0, 1, "", "Save recording as…", "File"},
    KeyBinding{Action::picture, GLFW_KEY_F12, 0, 1, "F12", "Save picture", "File"},
    KeyBinding{Action::export_picture, 0, 0, 1, "", "Save picture as…", "File"},
    KeyBinding{Action::picture_bare, 0, 0, 1, "", "Save picture without background", "File"},
    KeyBinding{Action::picture_window, GLFW_KEY_F12, shift, 1, "Shift+F12", "Save picture of the window", "File"},
    KeyBinding{Action::record, GLFW_KEY_R, ctrl, 1, PF_CTRL "+R", "Record…", "File"},
    KeyBinding{Action::quit, 0, 0, 1, "", "Quit", "File"},
    KeyBinding{Action::undo, GLFW_KEY_Z, ctrl, 1, PF_CTRL "+Z", "Undo", "Edit"},
    KeyBinding{Action::redo, GLFW_KEY_Z, ctrl | shift, 1, PF_CTRL "+Shift+Z", "Redo", "Edit"},
    KeyBinding{Action::run_pause, GLFW_KEY_SPACE, 0, 1, "Space", "Run or pause", "Run"},
    KeyBinding{Action::step, GLFW_KEY_RIGHT, 0, 1, "→", "One step", "Run"},
    KeyBinding{Action::slow_step, GLFW_KEY_T, 0, 1, "T", "One step, taken apart", "Run"},
    KeyBinding{Action::step_back, GLFW_KEY_LEFT, 0, 1, "←", "One step back", "Run"},
    KeyBinding{Action::bad_step, GLFW_KEY_B, 0, 1, "B", "Next bad step", "Run"},
    KeyBinding{Action::branch, 0, 0, 1, "", "Go on from here", "Run"},
    KeyBinding{Action::reset, GLFW_KEY_R, 0, 1, "R", "Reset", "Run"},
    KeyBinding{Action::fit, GLFW_KEY_F, 0, 1, "F", "Fit the view", "View"},
    KeyBinding{Action::grid, GLFW_KEY_G, 0, 1, "G", "Grid", "View"},
    KeyBinding{Action::vectors, GLFW_KEY_V, 0, 1, "V", "Velocity vectors", "View"},
    KeyBinding{Action::crosses, GLFW_KEY_X, 0, 1, "X", "Principal stress crosses", "View"},
    KeyBinding{Action::bent_grid, 0, 0, 1, "", "Grid bent by the step", "View"},
    KeyBinding{Action::shapes, GLFW_KEY_N, 0, 1, "N", "Shape functions under the mouse", "View"},
    KeyBinding{Action::field, GLFW_KEY_1, 0, 9, "1–9", "Colour by the nth field", "View"},
    KeyBinding{Action::hide_panels, GLFW_KEY_TAB, 0, 1, "Tab", "Hide all but the view", "View"},
    KeyBinding{Action::full_screen, GLFW_KEY_F11, 0, 1, "F11", "Full screen", "View"},
    KeyBinding{Action::help, GLFW_KEY_F1, 0, 1, "F1", "Keys and mouse", "Help"},
    KeyBinding{Action::deselect, GLFW_KEY_ESCAPE, 0, 1, "Esc", "Deselect, close", "View"},
};
// clang-format on

}  // namespace

std::span<const KeyBinding> key_bindings() {
  return bindings;
}

const KeyBinding& binding(Action action) {
  for (const KeyBinding& b : bindings)
    if (b.action == action) return b;
  std::abort();  // an action without a row: our own mistake
}

std::optional<KeyPress> find_key(int key, int mods) {
  mods &= GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  for (const KeyBinding& b : bindings)
    if (b.key != 0 && key >= b.key && key < b.key + b.keys && mods == b.mods) return KeyPress{b.action, key - b.key};
  return std::nullopt;
}

}  // namespace pf::app
