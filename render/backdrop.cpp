#include "render/backdrop.hpp"

namespace pf {

namespace {

void copy(GLuint from, const Viewport& source, GLuint to, const Viewport& target) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  const auto [w, h] = source.size;
  glBlitFramebuffer(source.x, source.y, source.x + w, source.y + h, target.x, target.y, target.x + w, target.y + h,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

GLuint bound() {
  GLint name = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
  return static_cast<GLuint>(name);
}

}  // namespace

Backdrop::Key Backdrop::Key::of(const Frame& frame) {
  const Snapshot& s = frame.snapshot;
  return {s.scene,       frame.camera,       frame.viewport.size,      s.boundary_displacement,
          frame.theme(), frame.options.grid, frame.options.boundaries, frame.scale(),
          s.spacing};
}

void Backdrop::show(const Frame& frame) const {
  const gl::TargetGuard guard;
  copy(framebuffer_.name(), {0, 0, size_}, bound(), frame.viewport);
}

void Backdrop::offer(const Frame& frame) {
  Key key = Key::of(frame);
  const bool again = key == key_;
  key_ = std::move(key);
  kept_ = false;
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLE_BUFFERS, &samples);
  if (!again || samples > 0) return;  // what is multisampled can be copied from, not to
  const gl::TargetGuard guard;
  const GLuint target = bound();
  if (size_ != frame.viewport.size) {
    size_ = frame.viewport.size;
    glBindRenderbuffer(GL_RENDERBUFFER, color_.name());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size_.width, size_.height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.name());
  }
  copy(target, frame.viewport, framebuffer_.name(), {0, 0, size_});
  kept_ = true;
}

}  // namespace pf
