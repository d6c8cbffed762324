#include "render/splats_2d.hpp"

#include <array>
#include <bit>
#include <cstring>

#include "render/color_texture.hpp"

namespace pf {

namespace {

/// The colour map's table as pixels, and grey for what is not a number.
class Colors {
 public:
  Colors(FieldScale scale, ValueRange range)
      : low_(static_cast<float>(range.min)), factor_(255.f / static_cast<float>(range.max - range.min)) {
    const auto bytes = field_texels(scale);
    std::memcpy(table_.data(), bytes.data(), bytes.size());
  }
  std::uint32_t operator()(float value) const {
    if (std::isnan(value)) return std::bit_cast<std::uint32_t>(Rgba8{128, 128, 128, 255});
    return table_[static_cast<std::size_t>(std::clamp((value - low_) * factor_ + 0.5f, 0.f, 255.f))];
  }

 private:
  std::array<std::uint32_t, 256> table_{};
  float low_, factor_;
};

}  // namespace

Splats2D::Rows Splats2D::fill(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  const auto [width, height] = size_;
  std::fill(pixels_.begin(), pixels_.end(), 0u);
  Rows rows{height, 0};
  const glm::vec2 range = frame.shown_range();
  const Colors colors(map_of(frame.color_scale()), {range.x, range.y});
  const bool has_F = s.F.size() >= 4 * s.particles, has_volume = s.volume0.size() >= s.particles;
  const double px = frame.pixels_per_metre, left = 0.5 * width, bottom = 0.5 * height;
  const float smallest = 0.75f * frame.scale();
  for (std::size_t p = 0; p < s.particles; ++p) {
    const float* F = &s.F[has_F ? 4 * p : 0];
    const float J = has_F ? std::max(F[0] * F[3] - F[1] * F[2], 0.f) : 1.f;
    const float area = (has_volume ? s.volume0[p] : static_cast<float>(0.25 * s.spacing * s.spacing)) * J;
    const double half = std::max(smallest, 0.5f * std::sqrt(area) * static_cast<float>(px));
    const double x = (s.x[2 * p] - frame.origin.x()) * px + left, y = (s.x[2 * p + 1] - frame.origin.y()) * px + bottom;
    if (!(x + half >= 0 && y + half >= 0 && x - half < width && y - half < height)) continue;
    const auto pixel = [](double v, int most) { return static_cast<int>(std::clamp(v + 0.5, 0.0, most + 0.0)); };
    const int x0 = pixel(x - half, width), x1 = pixel(x + half, width);
    const int y0 = pixel(y - half, height), y1 = pixel(y + half, height);
    const std::uint32_t color = colors(shown_value(frame, p));
    for (int row = y0; row < y1; ++row) {
      std::uint32_t* at = &pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width)];
      for (int column = x0; column < x1; ++column) at[column] = color;
    }
    rows = {std::min(rows.first, y0), std::max(rows.last, y1)};
  }
  return rows;
}

void Splats2D::draw(const Frame& frame) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  if (size_ != frame.viewport.size) {
    size_ = frame.viewport.size;
    pixels_.resize(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size_.width, size_.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  }
  const Rows rows = fill(frame);
  if (rows.first >= rows.last) return;
  const std::size_t start = static_cast<std::size_t>(rows.first) * static_cast<std::size_t>(size_.width);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, rows.first, size_.width, rows.last - rows.first, GL_RGBA, GL_UNSIGNED_BYTE,
                  &pixels_[start]);
  program_.use();
  program_.set("u_color", 0);
  program_.set("u_origin", glm::vec2(frame.viewport.x, frame.viewport.y));
  glEnable(GL_SCISSOR_TEST);
  glScissor(frame.viewport.x, frame.viewport.y + rows.first, size_.width, rows.last - rows.first);
  full_screen_.draw();
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace pf
