#include "app/studies/library.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/preferences.hpp"
#include "core/assets.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

namespace fs = std::filesystem;

namespace {

nlohmann::json parse(std::string_view text) {
  return nlohmann::json::parse(text, nullptr, false, true);
}

nlohmann::json read(const fs::path& file) {
  try {
    return parse(read_file(file));
  } catch (const FileError&) {
    return nullptr;
  }
}

std::string text_in(const nlohmann::json& json, const char* key) {
  return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : std::string();
}

std::size_t count_in(const nlohmann::json& json, const char* key) {
  return json.is_object() && json.contains(key) && json[key].is_number_unsigned() ? json[key].get<std::size_t>() : 0;
}

bool is_study(const nlohmann::json& json) {
  if (!json.is_object()) return false;
  // The word is not required of a study file; "vary" is.
  return json.contains("format") ? json["format"] == "pushforward/study" : json.contains("vary");
}

}  // namespace

fs::path default_study_folder() {
  return xdg_folder("XDG_DATA_HOME", ".local/share") / "studies";
}

fs::path results_folder(const fs::path& root, const Study& study) {
  const std::string hash = content_hash(study_identity(study) + program_identity() + study.name);
  return root / (file_stem(study.name, "study").substr(0, 60) + "-" + hash.substr(0, 8));
}

std::vector<LibraryEntry> shipped_studies() {
  std::vector<LibraryEntry> entries;
  std::error_code ignored;
  for (const fs::path& root : asset_roots()) {
    for (const auto& item : fs::directory_iterator(root / "studies", ignored)) {
      if (item.path().extension() != ".json") continue;
      const nlohmann::json json = read(item.path());
      if (!is_study(json)) continue;
      std::string name = text_in(json, "name");
      entries.push_back({item.path(), name.empty() ? item.path().stem().string() : name, text_in(json, "about")});
    }
    if (!entries.empty()) break;  // the first folder that has them, as for scenes
  }
  std::sort(entries.begin(), entries.end(),
            [](const LibraryEntry& a, const LibraryEntry& b) { return a.name < b.name; });
  return entries;
}

std::vector<LibraryEntry> earlier_studies(const fs::path& root, std::size_t most) {
  std::vector<std::pair<fs::file_time_type, fs::path>> folders;
  std::error_code ignored;
  for (const auto& item : fs::directory_iterator(root, ignored)) {
    const fs::path results = item.path() / "results.csv";
    if (fs::exists(item.path() / definition_name, ignored) && fs::exists(results, ignored))
      folders.emplace_back(fs::last_write_time(results, ignored), item.path());
  }
  std::sort(folders.rbegin(), folders.rend());
  std::vector<LibraryEntry> entries;
  for (const auto& [time, folder] : folders) {
    if (entries.size() == most) break;
    const nlohmann::json json = read(folder / definition_name), results = read(folder / "study.json");
    if (is_study(json))
      entries.push_back({folder / definition_name, text_in(json, "name"), text_in(json, "about"),
                         count_in(results, "runs"), count_in(results, "finished")});
  }
  return entries;
}

bool looks_like_study(std::string_view text) {
  return is_study(parse(text));
}

}  // namespace pf::app
