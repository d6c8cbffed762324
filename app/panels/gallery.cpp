#include "app/panels/gallery.hpp"

#define GLFW_INCLUDE_NONE  // epoxy brings OpenGL
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/charts/image.hpp"

namespace pf::app {

namespace fs = std::filesystem;

namespace {

std::string name_of_file(const fs::path& file) {
  std::string name = file.stem().string();
  std::replace(name.begin(), name.end(), '-', ' ');
  if (!name.empty()) name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return name;
}

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::shared_ptr<Thumbnail> upload(const Image& image) {
  auto result = std::make_shared<Thumbnail>();
  result->width = image.width;
  result->height = image.height;
  GLint before = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &before);
  glGenTextures(1, &result->texture);
  glBindTexture(GL_TEXTURE_2D, result->texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.pixels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(before));
  return result;
}

}  // namespace

Thumbnail::~Thumbnail() {
  if (texture != 0 && glfwGetCurrentContext() != nullptr) glDeleteTextures(1, &texture);
}

std::vector<GalleryEntry> list_scenes(const fs::path& folder) {
  std::vector<GalleryEntry> entries;
  std::error_code error;
  for (const fs::directory_entry& item : fs::directory_iterator(folder, error)) {
    if (item.path().extension() != ".json") continue;
    std::ifstream in(item.path());
    const auto json = nlohmann::json::parse(in, nullptr, false, true);
    if (!json.is_object() || !json.contains("bodies")) continue;
    const auto text = [&](const char* key) {
      return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : std::string();
    };
    GalleryEntry entry;
    entry.file = item.path();
    entry.name = text("name");
    entry.about = text("about");
    if (entry.name.empty()) entry.name = name_of_file(entry.file);
    if (json.contains("dimension") && json["dimension"].is_number_integer()) entry.dimension = json["dimension"];
    fs::path picture = entry.file;
    picture.replace_extension(".png");
    if (fs::exists(picture, error)) entry.picture = picture;
    entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const GalleryEntry& a, const GalleryEntry& b) {
    const bool first = a.file.stem() == "welcome", second = b.file.stem() == "welcome";
    return first != second ? first : a.name < b.name;
  });
  return entries;
}

int fuzzy_score(std::string_view filter, std::string_view text) {
  int score = 0;
  std::size_t at = 0;
  bool adjacent = false;
  for (const char wanted : filter) {
    if (wanted == ' ') continue;
    const std::size_t start = at;
    while (at < text.size() && lower(text[at]) != lower(wanted)) ++at;
    if (at == text.size()) return -1;
    const bool word = at == 0 || text[at - 1] == ' ' || text[at - 1] == '-';
    score += 1 + (word ? 6 : 0) + (adjacent && at == start ? 4 : 0);
    adjacent = true;
    ++at;
  }
  return score;
}

const Thumbnail* thumbnail(GalleryEntry& entry) {
  if (entry.picture_tried) return entry.thumbnail.get();
  if (entry.picture.empty() || glfwGetCurrentContext() == nullptr) return nullptr;
  entry.picture_tried = true;
  try {
    entry.thumbnail = upload(read_image(entry.picture));
  } catch (const std::runtime_error&) {
    // A broken picture is no reason not to offer the scene.
  }
  return entry.thumbnail.get();
}

}  // namespace pf::app
