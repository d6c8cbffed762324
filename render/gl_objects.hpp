// OpenGL names with an owner. Internal to render/.
#pragma once

#include <epoxy/gl.h>

#include <span>
#include <utility>
#include <vector>

namespace pf::gl {

/// Owns one OpenGL name; `Traits` knows how to make and delete it.
template <class Traits>
class Handle {
 public:
  Handle() { Traits::make(&name_); }
  ~Handle() {
    if (name_ != 0) Traits::remove(&name_);
  }
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

struct BufferTraits {
  static void make(GLuint* n) { glGenBuffers(1, n); }
  static void remove(const GLuint* n) { glDeleteBuffers(1, n); }
};
struct ArrayTraits {
  static void make(GLuint* n) { glGenVertexArrays(1, n); }
  static void remove(const GLuint* n) { glDeleteVertexArrays(1, n); }
};
struct TextureTraits {
  static void make(GLuint* n) { glGenTextures(1, n); }
  static void remove(const GLuint* n) { glDeleteTextures(1, n); }
};
struct FramebufferTraits {
  static void make(GLuint* n) { glGenFramebuffers(1, n); }
  static void remove(const GLuint* n) { glDeleteFramebuffers(1, n); }
};
struct RenderbufferTraits {
  static void make(GLuint* n) { glGenRenderbuffers(1, n); }
  static void remove(const GLuint* n) { glDeleteRenderbuffers(1, n); }
};
using Texture = Handle<TextureTraits>;
using Framebuffer = Handle<FramebufferTraits>;
using Renderbuffer = Handle<RenderbufferTraits>;
using VertexArray = Handle<ArrayTraits>;

/// One vertex attribute of an interleaved record: how many floats (or normalised bytes) at which offset.
struct Attribute {
  GLuint location;
  GLint components;
  std::size_t offset;
  GLenum type = GL_FLOAT;
};

/// Records of one kind in a buffer, drawn as instances of a four-vertex strip, as vertices or as points.
class Batch {
 public:
  Batch(std::size_t stride, std::span<const Attribute> attributes, bool instanced);
  template <class Record>
  void upload(const std::vector<Record>& records) {
    upload(records.data(), records.size(), sizeof(Record));
  }
  std::size_t count() const { return count_; }
  /// One quad (triangle strip of four vertices) a record.
  void draw_quads() const;
  void draw_vertices(GLenum mode) const;

 private:
  void upload(const void* data, std::size_t count, std::size_t stride);
  VertexArray array_;
  Handle<BufferTraits> buffer_;
  std::size_t count_ = 0, capacity_ = 0;
};

/// A triangle over the whole viewport; the shader makes its corners from gl_VertexID.
class FullScreen {
 public:
  void draw() const;
  /// The corners of a square instead, as a strip.
  void draw_square() const;

 private:
  VertexArray array_;
};

/// Restores the framebuffer binding and the viewport when it goes out of scope.
class TargetGuard {
 public:
  TargetGuard();
  ~TargetGuard();
  TargetGuard(const TargetGuard&) = delete;
  TargetGuard& operator=(const TargetGuard&) = delete;
  void restore() const;

 private:
  GLint framebuffer_ = 0;
  GLint viewport_[4] = {0, 0, 0, 0};
};

}  // namespace pf::gl
