// The operating system's window, its OpenGL context and ImGui's backends; input as plain lists.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/charts/image.hpp"

struct GLFWwindow;

namespace pf::app {

/// No window can be opened here; what() says why.
class DisplayError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct WindowSize {
  int width = 1280, height = 800;  ///< in screen coordinates
  bool maximized = false;
};

/// One at a time, on the main thread. The context is current from construction to destruction.
class GlfwWindow {
 public:
  GlfwWindow(const std::string& title, WindowSize size, bool visible);  ///< throws DisplayError
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  struct Key {
    int key = 0, mods = 0;  ///< GLFW's; letters as the user's keyboard is labelled
    bool repeated = false;
  };
  /// Handles what happened; sleeps until something does, at most `seconds` (0: not at all).
  void wait(double seconds);
  /// Ends another thread's or this thread's wait().
  static void wake();

  /// What came since the last call of each. Keys only while ImGui wants no keyboard.
  std::vector<Key> take_keys();
  std::vector<std::filesystem::path> take_dropped();
  /// Anything that may change the picture: input, size, exposure.
  bool take_touched();
  bool take_close_request();
  bool take_focus_lost();

  /// A mouse that is not the screen's: of a script, a test, a lesson.
  struct Pointer {
    float x = 0, y = 0;  ///< in the window, y downwards
    std::array<bool, 3> down{};
    float wheel = 0;  ///< notches since the last frame
    bool shift = false, ctrl = false;
  };
  /// From the next frame on the window follows this one; nothing: the screen's again.
  void feed(const std::optional<Pointer>& pointer) {
    fed_ = pointer;
    touched_ = true;
  }
  /// A key as if it had been pressed.
  void feed_key(const Key& key) {
    keys_.push_back(key);
    touched_ = true;
  }

  void begin_frame();  ///< of ImGui and OpenGL
  void end_frame();    ///< draws ImGui over what is there
  /// Closes what a frame that was thrown out of has left open.
  void abandon_frame();
  void show();         ///< what was drawn; the framebuffer's contents are lost
  Image read() const;  ///< what was drawn and is not yet shown
  /// Renews the texture of the font atlas.
  void renew_fonts();

  void set_title(const std::string& title);
  void toggle_full_screen();
  bool full_screen() const { return full_screen_; }
  WindowSize size() const;        ///< as to be restored next time
  float content_scale() const;    ///< of text, by the screen: 2 on HiDPI X11 and Windows, 1 on macOS
  float pixels_per_unit() const;  ///< framebuffer pixels per screen coordinate: 2 on macOS' Retina
  int framebuffer_height() const;

 private:
  struct Callbacks;
  /// Buttons that came down at a place which no frame has drawn the mouse at yet.
  struct HeldPress {
    float x, y;
    std::array<bool, 5> down;
  };
  void create(const std::string& title, WindowSize size, bool visible);
  /// ImGui's tabs take a press only where the mouse was a frame ago. A press that comes with the motion to its place,
  /// as it does when frames are slow, is handed on one frame later.
  void hold_presses();
  void take_fed_pointer();
  GLFWwindow* window_ = nullptr;
  std::optional<HeldPress> held_;
  std::optional<Pointer> fed_;
  std::vector<int> tapped_;  ///< keys that came down since the last frame
  std::vector<Key> keys_;
  std::vector<std::filesystem::path> dropped_;
  bool touched_ = true, close_ = false, focus_lost_ = false, full_screen_ = false;
  int restore_x_ = 0, restore_y_ = 0;
  WindowSize restore_;
};

}  // namespace pf::app
