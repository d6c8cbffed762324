// Study files: JSON, read as strictly as scenes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/studies/study.hpp"

namespace pf {

/// Reads and checks a study: every problem with its pointer and line. The scene is looked for beside the file, in a
/// folder scenes beside its own, and among the shipped ones. Values that no run could use are problems; a combination
/// that does not go together is not: it becomes a row that says so. Throws FileError, InputError.
Study load_study(const std::filesystem::path& file);
/// The same from text; `folder` is where the scene is looked for.
Study parse_study(std::string_view text, const std::string& source, const std::filesystem::path& folder);

/// The text of a study file with the scene inside it, whatever the scene's file becomes. `study`: what `text` was read
/// as. Reading the result gives the same runs.
std::string self_contained(std::string_view text, const Study& study);

}  // namespace pf
