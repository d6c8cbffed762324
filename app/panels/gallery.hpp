// The shipped scenes: what is offered, found by a few letters.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pf::app {

/// A picture on the GPU; deleted with its last owner, while its OpenGL context still lives.
struct Thumbnail {
  unsigned texture = 0;
  int width = 0, height = 0;  ///< [pixels]
  ~Thumbnail();
};

struct GalleryEntry {
  std::filesystem::path file;
  std::string name, about;  ///< from the file; the name falls back on the file's
  int dimension = 2;
  std::filesystem::path picture;  ///< empty: none is shipped
  std::shared_ptr<Thumbnail> thumbnail;
  bool picture_tried = false;
};

struct GalleryMemory {
  bool listed = false;
  std::vector<GalleryEntry> entries;
  std::string filter;
};

/// Every *.json of `folder`, by name; the welcome scene first. Files that are no scene are left out.
std::vector<GalleryEntry> list_scenes(const std::filesystem::path& folder);
/// How well the letters of `filter` are found in `text`, in their order and whatever their case: the higher the
/// better, letters side by side and beginnings of words count more; negative: not found.
int fuzzy_score(std::string_view filter, std::string_view text);
/// Loads the picture once, when there is one and an OpenGL context is current; nullptr otherwise.
const Thumbnail* thumbnail(GalleryEntry& entry);

}  // namespace pf::app
