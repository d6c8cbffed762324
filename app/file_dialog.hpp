// Choosing a file to open or a name to save under: a dialog of our own, as ImGui has none.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pf::app {

class FileDialog {
 public:
  enum class Purpose { open, save };
  struct Request {
    Purpose purpose = Purpose::open;
    std::string title;                          ///< "Open scene"
    std::string extension = ".json";            ///< shown and, when saving, added
    std::filesystem::path start;                ///< a folder, or a file to propose
    std::vector<std::filesystem::path> places;  ///< offered at the side: recent folders, shipped scenes
    std::function<void(const std::filesystem::path&)> done;
  };

  void ask(Request request);
  bool is_open() const { return open_; }
  void close() { open_ = false; }
  /// Once a frame.
  void draw();

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    std::string size, changed;
  };
  void go_to(const std::filesystem::path& folder);
  void list();
  void draw_path();
  void draw_places();
  void draw_entries(float height);
  void draw_buttons();
  void accept();
  std::filesystem::path chosen() const;

  Request request_;
  bool open_ = false, appear_ = false;
  bool overwrite_asked_ = false;
  std::filesystem::path folder_;
  std::string folder_text_, name_, trouble_;
  std::vector<Entry> entries_;
  bool focus_name_ = false;
};

/// `name` with `extension` added unless it ends so, whatever its case.
std::filesystem::path with_extension(std::filesystem::path name, const std::string& extension);

}  // namespace pf::app
