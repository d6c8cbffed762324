#include "app/glfw_window.hpp"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

#include "backends/imgui_impl_glfw.h"
#include "backends/imgui_impl_opengl3.h"

namespace pf::app {
namespace {

/// GLFW's account of its last error.
std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "unknown reason";
}

/// Letters by what is printed on them: Ctrl+Z is where the user sees a Z.
int labelled_key(int key, int scancode) {
  if (key < GLFW_KEY_A || key > GLFW_KEY_Z) return key;
  const char* name = glfwGetKeyName(key, scancode);
  const bool letter = name && name[0] && !name[1] && std::isalpha(static_cast<unsigned char>(name[0]));
  return letter ? std::toupper(static_cast<unsigned char>(name[0])) : key;
}

}  // namespace

/// ImGui's backend calls these first (it was installed after them), then its own.
struct GlfwWindow::Callbacks {
  static GlfwWindow& of(GLFWwindow* w) {
    auto& window = *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(w));
    window.touched_ = true;
    return window;
  }
  static void key(GLFWwindow* w, int key, int scancode, int action, int mods) {
    GlfwWindow& self = of(w);
    const ImGuiIO& io = ImGui::GetIO();
    if (action == GLFW_PRESS && key >= 0 && key < IM_ARRAYSIZE(io.KeysDown)) self.tapped_.push_back(key);
    if (action == GLFW_RELEASE || io.WantTextInput) return;
    // Escape closes popups, which want the keyboard, too.
    if (io.WantCaptureKeyboard && key != GLFW_KEY_ESCAPE) return;
    self.keys_.push_back({labelled_key(key, scancode), mods, action == GLFW_REPEAT});
  }
  static void drop(GLFWwindow* w, int count, const char** paths) {
    of(w).dropped_.insert(of(w).dropped_.end(), paths, paths + count);
  }
  static void close(GLFWwindow* w) {
    of(w).close_ = true;
    glfwSetWindowShouldClose(w, GLFW_FALSE);  // whether it closes is for the user to say
  }
  static void focus(GLFWwindow* w, int focused) { of(w).focus_lost_ |= focused == 0; }
  static void install(GLFWwindow* w) {
    glfwSetKeyCallback(w, key);
    glfwSetDropCallback(w, drop);
    glfwSetWindowCloseCallback(w, close);
    glfwSetWindowFocusCallback(w, focus);
    glfwSetCharCallback(w, [](GLFWwindow* at, unsigned) { of(at); });
    glfwSetCursorPosCallback(w, [](GLFWwindow* at, double, double) { of(at); });
    glfwSetCursorEnterCallback(w, [](GLFWwindow* at, int) { of(at); });
    glfwSetMouseButtonCallback(w, [](GLFWwindow* at, int, int, int) { of(at); });
    glfwSetScrollCallback(w, [](GLFWwindow* at, double, double) { of(at); });
    glfwSetFramebufferSizeCallback(w, [](GLFWwindow* at, int, int) { of(at); });
    glfwSetWindowRefreshCallback(w, [](GLFWwindow* at) { of(at); });
    glfwSetWindowContentScaleCallback(w, [](GLFWwindow* at, float, float) { of(at); });
  }
};

GlfwWindow::GlfwWindow(const std::string& title, WindowSize size, bool visible) {
  glfwInitHint(GLFW_COCOA_CHDIR_RESOURCES, GLFW_FALSE);
  if (!glfwInit()) throw DisplayError(last_error());
  try {
    create(title, size, visible);
  } catch (...) {
    if (window_) glfwDestroyWindow(window_);
    glfwTerminate();
    throw;
  }
}

namespace {

/// No larger than the screen has room for; on several screens than the first one's.
WindowSize clamped(WindowSize size) {
  int x = 0, y = 0, width = 0, height = 0;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  if (width > 0) size.width = std::min(size.width, width);
  if (height > 0) size.height = std::min(size.height, height);
  return size;
}

}  // namespace

void GlfwWindow::create(const std::string& title, WindowSize wanted, bool visible) {
  const WindowSize size = clamped(wanted);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_MAXIMIZED, visible && size.maximized ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_SAMPLES, 0);  // the view smooths its own picture, ImGui its own lines
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "pushforward");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "pushforward");
  window_ = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
  if (!window_) throw DisplayError("the display offers no OpenGL 3.3 (" + last_error() + ")");
  glfwSetWindowSizeLimits(window_, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window_);
  if (epoxy_gl_version() < 33) throw DisplayError("the display offers no OpenGL 3.3");
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  Callbacks::install(window_);
  restore_ = size;

  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = io.LogFilename = nullptr;  // the layout is ours
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ConfigDragClickToInputText = false;
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

GlfwWindow::~GlfwWindow() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void GlfwWindow::wait(double seconds) {
  if (seconds > 0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
}
void GlfwWindow::wake() {
  glfwPostEmptyEvent();
}

std::vector<GlfwWindow::Key> GlfwWindow::take_keys() {
  return std::exchange(keys_, {});
}
std::vector<std::filesystem::path> GlfwWindow::take_dropped() {
  return std::exchange(dropped_, {});
}
bool GlfwWindow::take_touched() {
  return std::exchange(touched_, false);
}
bool GlfwWindow::take_close_request() {
  return std::exchange(close_, false);
}
bool GlfwWindow::take_focus_lost() {
  return std::exchange(focus_lost_, false);
}

void GlfwWindow::hold_presses() {
  ImGuiIO& io = ImGui::GetIO();
  const auto same = [](ImVec2 a, ImVec2 b) { return a.x == b.x && a.y == b.y; };
  const ImVec2 there = io.MousePos;
  if (held_)
    for (std::size_t i = 0; i < held_->down.size(); ++i) io.MouseDown[i] |= held_->down[i];
  if (held_) io.MousePos = {held_->x, held_->y};
  const bool moved = !held_ && ImGui::IsMousePosValid(&there) && !same(there, io.MousePosPrev);
  held_.reset();
  if (!moved) return;
  for (int i = 0; i < ImGuiMouseButton_COUNT; ++i) {
    if (!io.MouseDown[i] || io.MouseDownDuration[i] >= 0) continue;
    if (!held_) held_ = HeldPress{there.x, there.y, {}};
    held_->down[static_cast<std::size_t>(i)] = true;
    io.MouseDown[i] = false;
    touched_ = true;
  }
}

void GlfwWindow::take_fed_pointer() {
  if (!fed_) return;
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = {fed_->x, fed_->y};
  for (std::size_t i = 0; i < fed_->down.size(); ++i) io.MouseDown[i] = fed_->down[i];
  io.MouseWheel = std::exchange(fed_->wheel, 0.0F);
  io.KeyShift = fed_->shift;
  io.KeyCtrl = fed_->ctrl;
}

void GlfwWindow::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  take_fed_pointer();
  hold_presses();
  // A key that came down and up since the last frame would be lost on ImGui, which knows only what is down now.
  bool* down = ImGui::GetIO().KeysDown;
  std::erase_if(tapped_, [&](int key) { return std::exchange(down[key], true); });
  ImGui::NewFrame();
  for (const int key : std::exchange(tapped_, {})) down[key] = false;
}

void GlfwWindow::end_frame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void GlfwWindow::abandon_frame() {
  if (!GImGui->WithinFrameScope) return;
  ImGui::ErrorCheckEndFrameRecover(nullptr);
  ImGui::EndFrame();
}

void GlfwWindow::show() {
  glfwSwapBuffers(window_);
}

Image GlfwWindow::read() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  Image image(width, height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadBuffer(GL_BACK);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
  image.flip_rows();
  return image;
}

void GlfwWindow::renew_fonts() {
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

void GlfwWindow::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

void GlfwWindow::toggle_full_screen() {
  if (full_screen_) {
    glfwSetWindowMonitor(window_, nullptr, restore_x_, restore_y_, restore_.width, restore_.height, GLFW_DONT_CARE);
    full_screen_ = false;
    return;
  }
  glfwGetWindowPos(window_, &restore_x_, &restore_y_);
  restore_ = size();
  // The monitor that holds the window's middle, else the first one.
  GLFWmonitor* chosen = glfwGetPrimaryMonitor();
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    int x = 0, y = 0;
    glfwGetMonitorPos(monitors[i], &x, &y);
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    const int cx = restore_x_ + restore_.width / 2, cy = restore_y_ + restore_.height / 2;
    if (mode && cx >= x && cx < x + mode->width && cy >= y && cy < y + mode->height) chosen = monitors[i];
  }
  const GLFWvidmode* mode = chosen ? glfwGetVideoMode(chosen) : nullptr;
  if (!mode) return;
  glfwSetWindowMonitor(window_, chosen, 0, 0, mode->width, mode->height, mode->refreshRate);
  full_screen_ = true;
}

WindowSize GlfwWindow::size() const {
  if (full_screen_) return restore_;
  WindowSize now;
  glfwGetWindowSize(window_, &now.width, &now.height);
  now.maximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
  return now;
}

float GlfwWindow::content_scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  // Where the framebuffer is finer than the screen coordinates the system scales already.
  return std::clamp(x / pixels_per_unit(), 0.5f, 4.0f);
}

float GlfwWindow::pixels_per_unit() const {
  int width = 1, pixels = 1, unused = 0;
  glfwGetWindowSize(window_, &width, &unused);
  glfwGetFramebufferSize(window_, &pixels, &unused);
  return width > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(width) : 1;
}

int GlfwWindow::framebuffer_height() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return height;
}

}  // namespace pf::app
