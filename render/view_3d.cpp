#include "render/view_3d.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace pf {

namespace {

glm::vec3 to_glm(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

glm::mat4 view_matrix(const OrbitCamera& camera) {
  const glm::vec3 r = to_glm(camera.right()), u = to_glm(camera.up()), f = to_glm(camera.forward());
  const glm::mat4 turn(r.x, u.x, -f.x, 0, r.y, u.y, -f.y, 0, r.z, u.z, -f.z, 0, 0, 0, 0, 1);
  return glm::translate(glm::mat4(1), glm::vec3(0, 0, -camera.distance)) * turn;
}

}  // namespace

void View3D::invalidate() {
  particles_.invalidate();
  boundaries_.invalidate();
}

Shadow View3D::draw_shadow(const Frame& frame) {
  Shadow shadow;
  const ViewBounds body = boundaries_.with_solids(frame.snapshot, particles_.bounds());
  const bool wanted = frame.options.shadows && (frame.options.best_quality || !frame.software);
  shadow_map_.resize(wanted ? ViewSize{1024, 1024} : ViewSize{1, 1});
  if (wanted) {
    // The light sees a ball around the body; what is shadowed may lie far beyond it.
    const auto radius = static_cast<float>(0.55 * body.size().norm());
    const glm::vec3 centre = to_glm(body.centre() - frame.origin);
    const glm::mat4 view = glm::lookAt(centre + 2.f * radius * towards_light, centre, glm::vec3(0, 0, 1));
    const glm::mat4 projection = glm::ortho(-radius, radius, -radius, radius, 0.5f * radius, 12.f * radius);
    shadow_map_.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    if (frame.options.particles) particles_.draw_shadow(frame, view, projection);
    if (frame.options.boundaries) boundaries_.draw_shadow(frame, projection * view);
    glDisable(GL_POLYGON_OFFSET_FILL);
    shadow.on = true;
    // Receivers are a little nearer to the light than they are: no surface shadows itself.
    const glm::mat4 bias = glm::translate(glm::mat4(1), glm::vec3(0, 0, -0.004f)) *
                           glm::translate(glm::mat4(1), glm::vec3(0.5f)) * glm::scale(glm::mat4(1), glm::vec3(0.5f));
    shadow.to_map = bias * projection * view;
    shadow.softness = 0.018f;
  }
  shadow_map_.bind_depth(2);
  return shadow;
}

void View3D::compose(const Frame& inner) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  body_.bind_color(0);
  body_.bind_depth(1);
  composite_.use();
  composite_.set("u_color", 0);
  composite_.set("u_depth", 1);
  composite_.set("u_near_far", glm::vec2(near_, far_));
  composite_.set("u_radius", std::max(1.5f, 1.4f * inner.scale()));
  composite_.set("u_strength", 6.f);
  full_screen_.draw();
  glDepthFunc(GL_LEQUAL);
}

void View3D::resolve(const Frame& frame) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glViewport(frame.viewport.x, frame.viewport.y, frame.viewport.size.width, frame.viewport.size.height);
  picture_.bind_color(0);
  resolve_.use();
  resolve_.set("u_color", 0);
  resolve_.set("u_origin", glm::vec2(frame.viewport.x, frame.viewport.y));
  resolve_.set("u_size", frame.size());
  resolve_.set("u_opaque", frame.options.transparent ? 0.f : 1.f);
  full_screen_.draw();
  glEnable(GL_BLEND);
}

void View3D::draw(Frame& frame, Background& background, GridLayer& grid, ColorTexture& colors, InkPrograms& ink,
                  const gl::TargetGuard& destination) {
  const auto& camera = std::get<OrbitCamera>(frame.camera);
  // Twice as many pixels each way, but on the CPU: impostors have no edges that multisampling would see.
  const int finer = frame.software && !frame.options.best_quality ? 1 : 2;
  RenderOptions options = frame.options;
  options.pixel_scale *= static_cast<float>(finer);
  Frame inner(frame.snapshot, options, frame.camera,
              {0, 0, {finer * frame.viewport.size.width, finer * frame.viewport.size.height}}, frame.software);
  inner.origin = camera.target;
  inner.range = frame.range;
  inner.pixels_per_metre = camera.pixels_per_metre(inner.viewport.size);
  particles_.prepare(inner);
  if (options.boundaries || options.regions) boundaries_.prepare(inner, particles_.bounds());
  const ViewBounds& body = particles_.bounds();
  const double to_body = (body.centre() - camera.eye()).norm() + body.size().norm();
  near_ = static_cast<float>(0.01 * camera.distance);
  far_ = static_cast<float>(40 * std::max(camera.distance, to_body));
  const glm::mat4 view = view_matrix(camera);
  const glm::mat4 projection =
      glm::perspective(static_cast<float>(camera.field_of_view), inner.size().x / inner.size().y, near_, far_);
  frame.origin = inner.origin;
  frame.pixels_per_metre = camera.pixels_per_metre(frame.viewport.size);
  frame.view_projection = inner.view_projection = projection * view;

  body_.resize(inner.viewport.size);
  picture_.resize(inner.viewport.size);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  const Shadow shadow = draw_shadow(inner);
  body_.bind();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (options.particles) particles_.draw(inner, view, projection, shadow, colors);

  picture_.bind();
  glClear(GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  background.draw(inner);
  compose(inner);
  glEnable(GL_BLEND);
  if (options.boundaries) boundaries_.draw_solids(inner, shadow, body);
  glDepthMask(GL_FALSE);
  if (options.regions) boundaries_.draw_regions(inner, ink);
  grid.draw(inner, ink);
  glDisable(GL_DEPTH_TEST);
  particles_.draw_marks(inner, ink);
  glDepthMask(GL_TRUE);
  destination.restore();
  resolve(frame);
}

}  // namespace pf
