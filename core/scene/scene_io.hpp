// Scene text <-> Scene value, and every problem in it, not just the first.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.hpp"

namespace pf {

/// One thing that is wrong with an input, and what would be right.
struct Problem {
  std::string pointer;  ///< JSON pointer, "" for the whole document
  std::string found;    ///< what is there
  std::string allowed;  ///< what may be there; nearest known key, range with unit, choices
  int line = 0;         ///< 1-based line in the file, 0 when unknown
};

/// The user's input is wrong. The only exception of core that is the user's to mend.
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::vector<Problem> problems);
  const std::string& file() const { return file_; }
  const std::vector<Problem>& problems() const { return problems_; }  ///< at least one

 private:
  std::string file_;
  std::vector<Problem> problems_;
};

/// A file could not be read or written (exit status 4).
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads, applies `edits` in order to the scene with its defaults filled in, validates all. Throws FileError
/// or InputError.
Scene load_scene(const std::filesystem::path& file, std::span<const Edit> edits = {});
/// The same from text; `source` names it in messages.
Scene parse_scene(std::string_view text, const std::string& source, std::span<const Edit> edits = {});
/// A checked scene with the edits applied, validated again. Throws InputError.
Scene edited(const Scene& scene, std::span<const Edit> edits);
/// "/pointer=VALUE" as --set takes it: split at the first '='; text that is not JSON is a string.
Edit parse_set(std::string_view argument);

/// All keys, defaults included; reading it back gives an equal Scene.
nlohmann::ordered_json to_json(const Scene& scene);
/// to_json laid out for people: what save writes (short arrays on one line).
std::string scene_text(const Scene& scene);
/// Writes atomically (temporary file, rename). Throws FileError.
void save_scene(const Scene& scene, const std::filesystem::path& file);
/// JSON Schema (2020-12) of the scene file, from the tables that parse it.
nlohmann::ordered_json scene_schema();
/// 16 hex digits of a hash of to_json(scene).
std::string scene_hash(const Scene& scene);

}  // namespace pf
