#include "render/gl_objects.hpp"

#include <algorithm>
#include <cstdint>

namespace pf::gl {

Batch::Batch(std::size_t stride, std::span<const Attribute> attributes, bool instanced) {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  for (const Attribute& a : attributes) {
    glEnableVertexAttribArray(a.location);
    glVertexAttribPointer(a.location, a.components, a.type, a.type == GL_FLOAT ? GL_FALSE : GL_TRUE,
                          static_cast<GLsizei>(stride), reinterpret_cast<const void*>(a.offset));
    if (instanced) glVertexAttribDivisor(a.location, 1);
  }
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Batch::upload(const void* data, std::size_t count, std::size_t stride) {
  count_ = count;
  if (count == 0) return;
  const std::size_t bytes = count * stride;
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  // Growing with some room, and orphaning otherwise: the driver need not wait for the last frame.
  if (bytes > capacity_) capacity_ = bytes + bytes / 4;
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_), nullptr, GL_STREAM_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes), data);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Batch::draw_quads() const {
  if (count_ == 0) return;
  glBindVertexArray(array_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count_));
  glBindVertexArray(0);
}

void Batch::draw_vertices(GLenum mode) const {
  if (count_ == 0) return;
  glBindVertexArray(array_.name());
  glDrawArrays(mode, 0, static_cast<GLsizei>(count_));
  glBindVertexArray(0);
}

void FullScreen::draw() const {
  glBindVertexArray(array_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void FullScreen::draw_square() const {
  glBindVertexArray(array_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
}

TargetGuard::TargetGuard() {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
  glGetIntegerv(GL_VIEWPORT, viewport_);
}
TargetGuard::~TargetGuard() {
  restore();
}
void TargetGuard::restore() const {
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
}

}  // namespace pf::gl
