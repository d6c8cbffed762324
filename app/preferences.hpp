// What the window remembers between sessions: preferences under XDG_CONFIG_HOME, recent files under XDG_STATE_HOME.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/context.hpp"

namespace pf::app {

struct Preferences {
  Theme theme = Theme::dark;
  float ui_scale = 1;
  int window_width = 1280, window_height = 800;  ///< in screen coordinates
  bool maximized = false;
  bool drawer_open = false;
  float drawer_height = 19.5F;                ///< [em]
  int rewind_megabytes = 512;                 ///< for states to go back to
  std::vector<std::filesystem::path> recent;  ///< newest first, absolute
  bool operator==(const Preferences&) const = default;
};

inline constexpr std::size_t most_recent_files = 10;

/// Where they are kept: `config`/preferences.json and `state`/recent.json.
struct PreferenceFolders {
  std::filesystem::path config, state;
};
/// $XDG_CONFIG_HOME/pushforward and $XDG_STATE_HOME/pushforward, by their defaults below $HOME where unset.
PreferenceFolders default_folders();

/// Values that are missing, mistyped or out of range keep their defaults: a damaged file never stops the program.
Preferences load_preferences(const PreferenceFolders& folders);
/// Writes both files atomically. Throws FileError.
void save_preferences(const Preferences& preferences, const PreferenceFolders& folders);
/// Back to the defaults; recent files are forgotten, too. Throws FileError.
void forget_preferences(const PreferenceFolders& folders);
/// Moves `file` to the front of the recent ones.
void note_recent(Preferences& preferences, const std::filesystem::path& file);

/// $`variable`/pushforward, or `below_home`/pushforward in $HOME where it is unset or relative.
std::filesystem::path xdg_folder(const char* variable, const char* below_home);
/// A name as a file's: "Falling block" -> "falling-block"; `otherwise` where nothing is left of it.
std::string file_stem(std::string_view name, std::string_view otherwise);

/// Through a temporary file in the same folder, which is made when missing, and a rename: readers see the old text
/// or the new. Throws FileError.
void write_atomically(const std::filesystem::path& file, std::string_view text);

}  // namespace pf::app
