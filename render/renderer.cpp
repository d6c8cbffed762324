#include "render/renderer.hpp"

#include <epoxy/gl.h>

#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>

#include "render/backdrop.hpp"
#include "render/background.hpp"
#include "render/boundary_layer_2d.hpp"
#include "render/cross_layer.hpp"
#include "render/grid_layer.hpp"
#include "render/particle_layer_2d.hpp"
#include "render/view_3d.hpp"

namespace pf {

namespace {

bool is_software() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string_view renderer = name ? name : "";
  for (const std::string_view known : {"llvmpipe", "softpipe", "swrast", "SWR", "Software"})
    if (renderer.find(known) != std::string_view::npos) return true;
  return false;
}

void require_gl33() {
  if (epoxy_gl_version() >= 33) return;
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  throw std::runtime_error(std::string("OpenGL 3.3 is needed; this context offers ") + (version ? version : "none"));
}

/// The grab: from where the material is held to where the mouse is.
void upload_grab(const Frame& frame, Ink& ink, Anchor& anchor) {
  anchor.drop_at(frame);
  const Rgba8 color = rgba8(frame.theme().selection);
  const glm::vec3 at = relative(frame.snapshot.grab_at, anchor), to = relative(frame.snapshot.grab_target, anchor);
  const auto radius = static_cast<float>(frame.snapshot.grab_radius * frame.pixels_per_metre) / frame.scale();
  std::vector<Mark> marks{{at, color, 3.5f, static_cast<float>(MarkStyle::dot)},
                          {to, color, 5, static_cast<float>(MarkStyle::ring)}};
  Rgba8 faint = color;
  faint.a = 110;
  if (radius > 5) marks.push_back({at, faint, radius, static_cast<float>(MarkStyle::ring)});
  ink.upload({{at, to, color}}, marks);
}

}  // namespace

struct Renderer::Impl {
  Background background;
  Backdrop backdrop;
  ColorTexture colors;
  InkPrograms ink;
  BoundaryLayer2D boundaries_2d;
  ParticleLayer2D particles_2d;
  GridLayer grid;
  CrossLayer crosses;
  View3D view_3d;
  Ink grab;
  Anchor grab_anchor;
  AutoRange auto_range;
  DataKey range_key;
  ValueRange range;
  RenderTheme theme;
  Field field = Field::speed;
  ColorScale scale = ColorScale::from_zero;
  std::shared_ptr<const SceneView> scene;  // kept alive, so that its address identifies it
  bool software = false;

  void invalidate() {
    backdrop.invalidate();
    boundaries_2d.invalidate();
    particles_2d.invalidate();
    view_3d.invalidate();
    grid.invalidate();
    crosses.invalidate();
  }
  void update_range(Frame& frame);
  void draw_flat(Frame& frame);
};

void Renderer::Impl::update_range(Frame& frame) {
  const FieldInfo& info = field_info(frame.options.field);
  const ColorScale now = color_scale(frame.options);
  if (field != info.field || scale != now) auto_range.reset();
  field = info.field;
  const DataKey key = DataKey::of(frame);
  if (key != range_key || scale != now)
    auto_range.update(frame.snapshot.field[static_cast<std::size_t>(info.field)], info, now);
  range_key = key;
  scale = now;
  range = auto_range.range();
  const auto& wanted = frame.options.range;
  const bool usable = wanted && wanted->max > wanted->min && (now != ColorScale::logarithmic || wanted->min > 0);
  if (now == ColorScale::categorical)
    range = {0, 255};
  else if (usable)
    range = *wanted;
  frame.range = range;
}

void Renderer::Impl::draw_flat(Frame& frame) {
  const auto& camera = std::get<Camera2D>(frame.camera);
  frame.origin = {camera.centre.x(), camera.centre.y(), 0};
  frame.pixels_per_metre = camera.pixels_per_metre;
  const glm::vec2 half = 0.5f * frame.size() / static_cast<float>(camera.pixels_per_metre);
  frame.view_projection = glm::ortho(-half.x, half.x, -half.y, half.y, -1.f, 1.f);

  if (frame.options.boundaries || frame.options.regions) boundaries_2d.prepare(frame);
  const bool slow = frame.software && !frame.options.best_quality && !frame.options.transparent;
  if (slow && backdrop.serves(frame)) {
    backdrop.show(frame);
  } else {
    background.draw(frame);  // or clears
    if (frame.options.boundaries) boundaries_2d.draw_solids(frame);
    if (slow) backdrop.offer(frame);
  }
  if (frame.options.grid) grid.draw_cells(frame);
  if (frame.options.particles) particles_2d.draw(frame, colors, ink);
  if (frame.options.regions) boundaries_2d.draw_regions(frame);
  grid.draw(frame, ink);
  crosses.draw(frame, ink);
}

Renderer::Renderer() {
  require_gl33();
  impl_ = std::make_unique<Impl>();
  impl_->software = is_software();
}
Renderer::~Renderer() = default;

void Renderer::draw(const Snapshot& snapshot, const RenderOptions& options, const Camera& camera,
                    const Viewport& viewport) {
  if (viewport.size.width <= 0 || viewport.size.height <= 0) return;
  Impl& im = *impl_;
  if (im.scene != snapshot.scene || !(im.theme == options.theme)) im.invalidate();
  im.scene = snapshot.scene;
  im.theme = options.theme;

  const gl::TargetGuard guard;
  glViewport(viewport.x, viewport.y, viewport.size.width, viewport.size.height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

  Frame frame(snapshot, options, camera, viewport, im.software);
  im.update_range(frame);
  if (frame.flat())
    im.draw_flat(frame);
  else
    im.view_3d.draw(frame, im.background, im.grid, im.colors, im.ink, guard);
  if (!frame.flat()) im.crosses.draw(frame, im.ink);  // over the body, which would hide them
  if (snapshot.grabbed) {
    upload_grab(frame, im.grab, im.grab_anchor);
    im.grab.draw(im.ink, frame, im.grab_anchor, 1.6f);
  }
  glUseProgram(0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glDisable(GL_BLEND);
}

ValueRange Renderer::range() const {
  return impl_->range;
}
void Renderer::forget_range() {
  impl_->auto_range.reset(), impl_->range_key = {};
}
void Renderer::invalidate() {
  impl_->invalidate(), impl_->range_key = {};
}
bool Renderer::software() const {
  return impl_->software;
}
double Renderer::arrow_pixels_per_speed() const {
  return impl_->grid.arrow_pixels_per_speed();
}

double Renderer::cross_pixels_per_pascal() const {
  return impl_->crosses.pixels_per_pascal();
}

std::string take_gl_errors() {
  std::string errors;
  for (GLenum e = glGetError(); e != GL_NO_ERROR; e = glGetError()) {
    char text[16];
    std::snprintf(text, sizeof text, "0x%04x ", e);
    errors += text;
    if (errors.size() > 200) break;
  }
  return errors;
}

}  // namespace pf
