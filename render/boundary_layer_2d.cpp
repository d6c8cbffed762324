#include "render/boundary_layer_2d.hpp"

#include "render/distance_map.hpp"

namespace pf {

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
  solids_ = map.solids;
  regions_ = map.regions;
  if (!solids_ && !regions_) return;
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
  if (solids ? !solids_ : !regions_) return;
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
  full_screen_.draw();
}

}  // namespace pf
