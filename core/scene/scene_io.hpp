// Scene text <-> Scene value, and every problem in it, not just the first.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/params/problem.hpp"
#include "core/scene/scene.hpp"

namespace pf {

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
