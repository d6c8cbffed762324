// Every keyboard shortcut, once: the window obeys this table, the menus and the help sheet print it.
#pragma once

#include <optional>
#include <span>

namespace pf::app {

enum class Action {
  open,
  save,
  save_as,
  save_recording,
  export_picture,
  picture,
  picture_bare,
  picture_window,
  record,
  quit,
  undo,
  redo,
  run_pause,
  step,
  slow_step,
  step_back,
  bad_step,
  branch,
  reset,
  fit,
  grid,
  vectors,
  crosses,
  bent_grid,
  shapes,
  field,
  hide_panels,
  full_screen,
  help,
  deselect,
};

struct KeyBinding {
  Action action;
  int key;               ///< GLFW_KEY_*; 0: no shortcut, in menus only
  int mods;              ///< of GLFW_MOD_CONTROL (Command on macOS) and GLFW_MOD_SHIFT
  int keys;              ///< this many in a row do the same with another index
  const char* shortcut;  ///< as people read it: "Ctrl+Shift+S"
  const char* label;     ///< in menus and the help sheet
  const char* group;     ///< File, Edit, Run, View, Help
};
std::span<const KeyBinding> key_bindings();
const KeyBinding& binding(Action action);

struct KeyPress {
  Action action;
  int index = 0;  ///< 0-based, where one binding has several keys
};
/// What a key of GLFW's callback means; extra modifiers (lock keys) are ignored, others must match.
std::optional<KeyPress> find_key(int key, int mods);

}  // namespace pf::app
