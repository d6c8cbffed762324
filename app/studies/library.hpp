// Studies that can be opened: the shipped ones, and earlier ones with their results. No drawing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/studies/study.hpp"

namespace pf::app {

/// $XDG_DATA_HOME/pushforward/studies, by its default below $HOME where unset: a folder of results for each study
/// that was run in the window.
std::filesystem::path default_study_folder();

/// Where the results of this study are kept below `root`: named after the study, its content and this program, so
/// that no study ever meets another one's results.
std::filesystem::path results_folder(const std::filesystem::path& root, const Study& study);
/// The study file inside a folder of results.
inline constexpr const char* definition_name = "definition.json";

struct LibraryEntry {
  std::filesystem::path file;  ///< the study file
  std::string name, about;
  std::size_t runs = 0, finished = 0;  ///< of an earlier study
};
/// By name. Files that are no study are left out.
std::vector<LibraryEntry> shipped_studies();
/// Those below `root`, the newest first, at most `most`.
std::vector<LibraryEntry> earlier_studies(const std::filesystem::path& root, std::size_t most = 12);

/// Does this JSON text claim to be a study file?
bool looks_like_study(std::string_view text);

}  // namespace pf::app
