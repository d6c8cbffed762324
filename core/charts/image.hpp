// A picture in memory: what the renderer reads back, what charts and overlays are painted on, what a PNG holds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/charts/painter.hpp"

namespace pf {

/// Straight-alpha sRGB, 8 bits a channel, rows from the top.
struct Image {
  int width = 0, height = 0;         ///< [pixels]
  std::vector<std::uint8_t> pixels;  ///< RGBA, 4 * width * height

  Image() = default;
  Image(int width, int height, Color fill = {0, 0, 0, 0});

  std::uint8_t* at(int x, int y) { return pixels.data() + 4 * (static_cast<std::size_t>(y) * width + x); }
  const std::uint8_t* at(int x, int y) const { return pixels.data() + 4 * (static_cast<std::size_t>(y) * width + x); }
  Color color(int x, int y) const;
  /// Turns bottom-up rows, as OpenGL reads them, the right way up.
  void flip_rows();
  /// Makes straight what OpenGL blended onto nothing: colours that were multiplied by their alpha.
  void unpremultiply();
};

/// Keyword and text of PNG tEXt or iTXt chunks: version, commit, scene hash. Keywords are 1 to 79 bytes of Latin-1.
using ImageText = std::vector<std::pair<std::string, std::string>>;

/// The bytes of a PNG file. Text that is not plain ASCII goes to iTXt (UTF-8). A fully opaque image is stored as RGB.
std::vector<std::uint8_t> encode_png(const Image& image, const ImageText& text = {});
/// Writes the whole file under a temporary name, then renames. Throws FileError.
void write_png(const Image& image, const std::filesystem::path& file, const ImageText& text = {});
/// Reads PNG, JPEG or BMP, at most 16384 pixels a side. Throws FileError.
Image read_image(const std::filesystem::path& file);
/// The text chunks of a PNG file. Throws FileError.
ImageText read_png_text(const std::filesystem::path& file);

}  // namespace pf
