// PNG in and out. stb does the codec, compiled here alone with internal linkage, so that it never meets a packaged
// libstb in one program; the text chunks, which it lacks, are ours (PNG specification, sections 5.3 and 11.3.4).
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include "core/charts/image.hpp"
#include "core/files.hpp"
#include "core/params/problem.hpp"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>

namespace pf {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t signature_size = 8, header_end = signature_size + 4 + 4 + 13 + 4;  // IHDR has 13 bytes

/// For our pictures, large areas of one colour, no filter gives smaller files than stb's choice of filter in half the
/// time; stb has these as variables.
[[maybe_unused]] const bool tuned = [] {
  stbi_write_force_png_filter = 0;
  stbi_write_png_compression_level = 5;
  return true;
}();

std::uint32_t crc32(const std::uint8_t* data, std::size_t size) {
  static constexpr auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320u ^ (c >> 1) : c >> 1;
      entries[n] = c;
    }
    return entries;
  }();
  std::uint32_t c = 0xffffffffu;
  for (std::size_t k = 0; k < size; ++k) c = table[(c ^ data[k]) & 0xff] ^ (c >> 8);
  return ~c;
}

void append_number(Bytes& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint32_t number_at(const Bytes& bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 | std::uint32_t{bytes[at + 2]} << 8 |
         std::uint32_t{bytes[at + 3]};
}

Bytes text_chunk(const std::string& keyword, const std::string& text) {
  const bool ascii = std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  std::string body = ascii ? "tEXt" + keyword : "iTXt" + keyword;
  body += '\0';
  if (!ascii) body.append(4, '\0');  // not compressed, no language, no translated keyword
  body += text;
  Bytes chunk;
  append_number(chunk, static_cast<std::uint32_t>(body.size() - 4));
  chunk.insert(chunk.end(), body.begin(), body.end());
  append_number(chunk, crc32(chunk.data() + 4, body.size()));
  return chunk;
}

Bytes read_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  Bytes bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in) throw FileError("cannot read " + file.string());
  return bytes;
}

}  // namespace

Bytes encode_png(const Image& image, const ImageText& text) {
  Bytes opaque;
  const std::size_t count = image.pixels.size() / 4;
  bool has_alpha = false;
  for (std::size_t k = 0; k < count && !has_alpha; ++k) has_alpha = image.pixels[4 * k + 3] != 255;
  if (!has_alpha) {
    opaque.resize(3 * count);
    for (std::size_t k = 0; k < count; ++k) std::copy_n(&image.pixels[4 * k], 3, &opaque[3 * k]);
  }
  Bytes png;
  const auto append = [](void* into, void* data, int size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    static_cast<Bytes*>(into)->insert(static_cast<Bytes*>(into)->end(), bytes, bytes + size);
  };
  const int channels = has_alpha ? 4 : 3;
  if (!stbi_write_png_to_func(append, &png, image.width, image.height, channels,
                              has_alpha ? image.pixels.data() : opaque.data(), channels * image.width)) {
    throw FileError("cannot encode a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height));
  }
  Bytes chunks;
  for (const auto& [keyword, value] : text) {
    const Bytes chunk = text_chunk(keyword, value);
    chunks.insert(chunks.end(), chunk.begin(), chunk.end());
  }
  png.insert(png.begin() + header_end, chunks.begin(), chunks.end());
  return png;
}

void write_png(const Image& image, const std::filesystem::path& file, const ImageText& text) {
  const Bytes png = encode_png(image, text);
  write_atomically(file, {reinterpret_cast<const char*>(png.data()), png.size()});
}

Image read_image(const std::filesystem::path& file) {
  const Bytes bytes = read_bytes(file);
  Image image;
  int channels = 0;
  stbi_uc* data =
      stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &image.width, &image.height, &channels, 4);
  if (!data) throw FileError("cannot read " + file.string() + " as a picture: " + stbi_failure_reason());
  image.pixels.assign(data, data + 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  stbi_image_free(data);
  return image;
}

ImageText read_png_text(const std::filesystem::path& file) {
  const Bytes bytes = read_bytes(file);
  ImageText found;
  for (std::size_t at = signature_size; at + 12 <= bytes.size();) {
    const std::size_t size = number_at(bytes, at);
    if (size > bytes.size() - at - 12) throw FileError(file.string() + " is a damaged PNG");
    const std::string type(&bytes[at + 4], &bytes[at + 8]), body(&bytes[at + 8], &bytes[at + 8] + size);
    const std::size_t keyword = std::min(body.find('\0'), body.size());
    const std::size_t skip = type == "iTXt" ? 5 : 1;
    if ((type == "tEXt" || type == "iTXt") && keyword + skip <= body.size()) {
      found.emplace_back(body.substr(0, keyword), body.substr(keyword + skip));
    }
    at += size + 12;
  }
  return found;
}

}  // namespace pf
