#include "app/preferences.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/theme.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json read(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  Json json = Json::parse(text.str(), nullptr, false);
  return json.is_discarded() ? Json() : json;
}

template <typename T>
void take_number(const Json& from, const char* key, T& into, double min, double max) {
  if (!from.is_object() || !from.contains(key) || !from.at(key).is_number()) return;
  const double value = from.at(key).get<double>();
  if (value >= min && value <= max) into = static_cast<T>(value);
}

void take_flag(const Json& from, const char* key, bool& into) {
  if (from.is_object() && from.contains(key) && from.at(key).is_boolean()) into = from.at(key).get<bool>();
}

}  // namespace

fs::path xdg_folder(const char* variable, const char* below_home) {
  // The specification: relative paths in these variables are to be ignored.
  if (const char* set = std::getenv(variable); set && *set == '/') return fs::path(set) / "pushforward";
  const char* home = std::getenv("HOME");
  return fs::path(home && *home ? home : "/tmp") / below_home / "pushforward";
}

std::string file_stem(std::string_view name, std::string_view otherwise) {
  std::string stem;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)))
      stem += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!stem.empty() && stem.back() != '-')
      stem += '-';
  }
  while (stem.ends_with('-')) stem.pop_back();
  return stem.empty() ? std::string(otherwise) : stem;
}

PreferenceFolders default_folders() {
  return {xdg_folder("XDG_CONFIG_HOME", ".config"), xdg_folder("XDG_STATE_HOME", ".local/state")};
}

Preferences load_preferences(const PreferenceFolders& folders) {
  Preferences p;
  const Json json = read(folders.config / "preferences.json");
  if (json.is_object() && json.value("theme", Json()) == "light") p.theme = Theme::light;
  take_number(json, "ui_scale", p.ui_scale, smallest_scale, largest_scale);
  take_number(json, "window_width", p.window_width, 320, 32768);
  take_number(json, "window_height", p.window_height, 240, 32768);
  take_flag(json, "maximized", p.maximized);
  take_flag(json, "drawer_open", p.drawer_open);
  take_number(json, "drawer_height", p.drawer_height, 4, 200);
  take_number(json, "rewind_megabytes", p.rewind_megabytes, 0, 1 << 20);
  const Json recent = read(folders.state / "recent.json");
  if (recent.is_array())
    for (const Json& file : recent)
      if (file.is_string() && p.recent.size() < most_recent_files) p.recent.emplace_back(file.get<std::string>());
  return p;
}

void save_preferences(const Preferences& p, const PreferenceFolders& folders) {
  const Json json{{"theme", p.theme == Theme::light ? "light" : "dark"},
                  {"ui_scale", std::round(100.0 * static_cast<double>(p.ui_scale)) / 100.0},
                  {"window_width", p.window_width},
                  {"window_height", p.window_height},
                  {"maximized", p.maximized},
                  {"drawer_open", p.drawer_open},
                  {"drawer_height", std::round(10.0 * static_cast<double>(p.drawer_height)) / 10.0},
                  {"rewind_megabytes", p.rewind_megabytes}};
  write_atomically(folders.config / "preferences.json", json.dump(2) + "\n");
  Json recent = Json::array();
  for (const fs::path& file : p.recent) recent.push_back(file.string());
  write_atomically(folders.state / "recent.json",
                   recent.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void forget_preferences(const PreferenceFolders& folders) {
  for (const fs::path& file : {folders.config / "preferences.json", folders.state / "recent.json"}) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw FileError("cannot remove " + file.string() + ": " + error.message());
  }
}

void note_recent(Preferences& preferences, const fs::path& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error).lexically_normal();
  auto& recent = preferences.recent;
  recent.erase(std::remove(recent.begin(), recent.end(), whole), recent.end());
  recent.insert(recent.begin(), whole);
  if (recent.size() > most_recent_files) recent.resize(most_recent_files);
}

void write_atomically(const fs::path& file, std::string_view text) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  const fs::path scratch = file.string() + "." + std::to_string(getpid()) + ".tmp";
  {
    std::ofstream out(scratch, std::ios::binary);
    out << text;
    out.flush();
    if (!out) {
      fs::remove(scratch, error);
      throw FileError("cannot write " + scratch.string());
    }
  }
  fs::rename(scratch, file, error);
  if (error) {
    const std::string why = error.message();
    fs::remove(scratch, error);
    throw FileError("cannot write " + file.string() + ": " + why);
  }
}

}  // namespace pf::app
