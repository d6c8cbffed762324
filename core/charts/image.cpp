#include "core/charts/image.hpp"

#include <algorithm>
#include <cmath>

namespace pf {

Image::Image(int width_, int height_, Color fill) : width(width_), height(height_) {
  const auto byte = [](float value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
  };
  pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const std::uint8_t texel[] = {byte(fill.r), byte(fill.g), byte(fill.b), byte(fill.a)};
  for (std::size_t k = 0; k < pixels.size(); ++k) pixels[k] = texel[k % 4];
}

Color Image::color(int x, int y) const {
  const std::uint8_t* p = at(x, y);
  const auto channel = [&](int a) { return static_cast<float>(p[a]) / 255; };
  return {channel(0), channel(1), channel(2), channel(3)};
}

void Image::flip_rows() {
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  for (int top = 0, bottom = height - 1; top < bottom; ++top, --bottom) {
    std::swap_ranges(at(0, top), at(0, top) + row, at(0, bottom));
  }
}

void Image::unpremultiply() {
  for (std::size_t k = 0; k + 3 < pixels.size(); k += 4) {
    const int alpha = pixels[k + 3];
    if (alpha == 0 || alpha == 255) continue;
    for (std::size_t a = 0; a < 3; ++a)
      pixels[k + a] = static_cast<std::uint8_t>(std::min(255, (255 * pixels[k + a] + alpha / 2) / alpha));
  }
}

}  // namespace pf
