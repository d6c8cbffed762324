#include "render/color_texture.hpp"

#include <cmath>
#include <limits>

#include "core/charts/colormap.hpp"
#include "render/frame.hpp"

namespace pf {

std::array<std::uint8_t, 1024> field_texels(FieldScale scale) {
  if (scale == FieldScale::sequential) return colormap_texels(ColormapKind::sequential);
  if (scale == FieldScale::diverging) return colormap_texels(ColormapKind::diverging);
  std::array<std::uint8_t, 1024> table;
  for (std::size_t k = 0; k < 256; ++k) {
    const Rgba8 c = rgba8(categorical_color(k));
    table[4 * k] = c.r, table[4 * k + 1] = c.g, table[4 * k + 2] = c.b, table[4 * k + 3] = c.a;
  }
  return table;
}

void ColorTexture::bind(FieldScale scale) {
  const auto k = static_cast<std::size_t>(scale);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, textures_[k].name());
  if (filled_[k]) return;
  const auto table = field_texels(scale);
  const GLint filter = scale == FieldScale::categorical ? GL_NEAREST : GL_LINEAR;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 256, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, table.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  filled_[k] = true;
}

float shown_value(const Frame& frame, std::size_t p) {
  const float value = color_value(frame.snapshot, frame.options.field, p);
  return frame.color_scale() == ColorScale::logarithmic ? std::log10(std::abs(value)) : value;
}

float color_value(const Snapshot& snapshot, Field field, std::size_t p) {
  const auto& values = snapshot.field[static_cast<std::size_t>(field)];
  if (field_info(field).on_nodes) return std::numeric_limits<float>::quiet_NaN();
  if (p < values.size()) return values[p];
  if (field == Field::material && p < snapshot.material.size()) return static_cast<float>(snapshot.material[p] % 256);
  return std::numeric_limits<float>::quiet_NaN();
}

}  // namespace pf
