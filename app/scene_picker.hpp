// Ctrl+O: a few letters find a shipped scene or a recent file; Enter opens it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pf::app {

struct SceneChoice {
  std::filesystem::path file;
  std::string name;   ///< of the scene, or of the file
  std::string place;  ///< "shipped", "2D", or the folder
};

/// Those whose name or file has the letters, the best first; all of them, in order, without letters.
std::vector<SceneChoice> matching(const std::vector<SceneChoice>& choices, const std::string& letters);

class ScenePicker {
 public:
  /// `recent` files are offered first, then the scenes of `shipped`.
  void open(const std::filesystem::path& shipped, const std::vector<std::filesystem::path>& recent);
  bool is_open() const { return open_; }
  /// Inside of ImGui's frame. `chosen` and `browse` (any other file) are called after it has closed.
  void draw(const std::function<void(const std::filesystem::path&)>& chosen, const std::function<void()>& browse);
  /// What it offers now.
  const std::vector<SceneChoice>& offered() const { return offered_; }

 private:
  void draw_list();

  std::vector<SceneChoice> choices_, offered_;
  std::string letters_;
  int at_ = 0;           ///< the one that Enter takes
  bool wanted_ = false;  ///< to be opened in the next frame
  bool open_ = false, follow_ = false, pressed_ = false;
};

}  // namespace pf::app
