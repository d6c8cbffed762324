#include "render/boundary_layer_2d.hpp"

namespace pf {

BoundaryLayer2D::Box BoundaryLayer2D::reach(const DistanceMap& map, std::initializer_list<std::size_t> channels,
                                            double margin) const {
  int left = map.columns, right = -1, bottom = map.rows, top = -1;
  for (int j = 0; j < map.rows; ++j)
    for (int i = 0; i < map.columns; ++i) {
      const float* d = &map.values[3 * (static_cast<std::size_t>(j) * map.columns + i)];
      const bool near = std::any_of(channels.begin(), channels.end(), [&](std::size_t k) { return d[k] < margin; });
      if (!near) continue;
      left = std::min(left, i), right = std::max(right, i);
      bottom = std::min(bottom, j), top = std::max(top, j);
    }
  const auto pixel = [&](int sample, int most) {
    return std::clamp(static_cast<int>(std::lround(sample * map.pitch)), 0, most);
  };
  // A sample's neighbours may show something, too.
  return {pixel(left - 1, size_.width), pixel(bottom - 1, size_.height), pixel(right + 2, size_.width),
          pixel(top + 2, size_.height)};
}

void BoundaryLayer2D::prepare(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  const Camera2D& camera = std::get<Camera2D>(frame.camera);
  if (scene_ == s.scene.get() && camera_ == camera && size_ == frame.viewport.size &&
      displacement_ == s.boundary_displacement)
    return;
  scene_ = s.scene.get();
  camera_ = camera;
  size_ = frame.viewport.size;
  displacement_ = s.boundary_displacement;

  const double pitch = 2 * std::max(1.f, std::round(frame.scale()));
  const DistanceMap map = DistanceMap::sample(s, camera, size_, pitch);
  const double line = 4.0 * static_cast<double>(frame.scale()) + 2;  // lines run beside the surfaces
  solids_ = map.solids ? reach(map, {0}, line) : Box{};
  regions_ = map.regions ? reach(map, {1, 2}, line) : Box{};
  if (solids_.empty() && regions_.empty()) return;
  uv_scale_ = frame.size() / static_cast<float>(pitch) / glm::vec2(map.columns, map.rows);
  uv_shift_ = 0.5f / glm::vec2(map.columns, map.rows);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, distance_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, map.columns, map.rows, 0, GL_RGB, GL_FLOAT, map.values.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

void BoundaryLayer2D::draw(const Frame& frame, bool solids) {
  const Box& box = solids ? solids_ : regions_;
  if (box.empty()) return;
  const RenderTheme& theme = frame.theme();
  // The hatching repeats every 10 sqrt(2) layout pixels along x and y (solids), so its phase may be reduced in
  // double; 90 of these also is a whole number of the regions' periods.
  const double period = 90 * std::sqrt(2.0) * frame.scale();
  const Vec3 phase = frame.origin * frame.pixels_per_metre;
  program_.use();
  program_.set("u_size", frame.size());
  program_.set("u_origin", glm::vec2(frame.viewport.x, frame.viewport.y));
  program_.set("u_phase", glm::vec2(std::remainder(phase.x(), period), std::remainder(phase.y(), period)));
  program_.set("u_scale", frame.scale());
  program_.set("u_uv_scale", uv_scale_);
  program_.set("u_uv_shift", uv_shift_);
  program_.set("u_fill", rgb(theme.solid));
  program_.set("u_hatch", rgb(theme.solid_hatch));
  program_.set("u_edge", rgb(theme.solid_edge));
  program_.set("u_constraint", rgb(theme.constraint));
  program_.set("u_load", rgb(theme.load));
  program_.set("u_solids", solids);
  program_.set("u_regions", !solids);
  program_.set("u_distance", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, distance_.name());
  glEnable(GL_SCISSOR_TEST);
  glScissor(frame.viewport.x + box.left, frame.viewport.y + box.bottom, box.right - box.left, box.top - box.bottom);
  full_screen_.draw();
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace pf
