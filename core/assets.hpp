// Where the files that the program ships (scenes, lessons, fonts, shaders) lie at run time.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace pf {

/// The folders that are searched, in order: $PUSHFORWARD_ASSETS; ../share/pushforward, assets and ../assets
/// beside the executable; the source tree's assets.
std::vector<std::filesystem::path> asset_roots();

/// The first existing file or folder called `relative` ("fonts/NotoSans-Regular.ttf", "scenes", "shaders/solid.vert")
/// below asset_roots(); shaders are found in the source tree's shaders/ too. Throws FileError, naming every place
/// that was tried.
std::filesystem::path asset_path(std::string_view relative);

}  // namespace pf
