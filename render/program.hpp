// A shader program from shaders/NAME.glsl. Internal to render/.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/charts/painter.hpp"

namespace pf {

/// Text of shaders/`name`.glsl, built in; empty when there is no such shader.
std::string_view shader_source(std::string_view name);

/// One file holds both stages, between #ifdef VERTEX and #ifdef FRAGMENT; shaders/common.glsl comes before it, and
/// before that #define `form`, if any. Throws std::runtime_error with the compiler's message.
class Program {
 public:
  explicit Program(std::string_view name, std::string_view form = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const;
  // Uniforms that the compiler removed are ignored. The program must be in use.
  void set(const char* uniform, int value);
  void set(const char* uniform, bool value) { set(uniform, value ? 1 : 0); }
  void set(const char* uniform, float value);
  void set(const char* uniform, const glm::vec2& value);
  void set(const char* uniform, const glm::vec3& value);
  void set(const char* uniform, const glm::vec4& value);
  void set(const char* uniform, const glm::mat3& value);
  void set(const char* uniform, const glm::mat4& value);

 private:
  GLint location(const char* uniform);
  GLuint name_ = 0;
  std::map<std::string, GLint, std::less<>> locations_;
};

/// A shader that may receive a shadow, in its two forms; each is made when it is first asked for. One form that asks a
/// uniform would do for a graphics card, but a software renderer works out either side of every question.
class ReceiverProgram {
 public:
  explicit ReceiverProgram(std::string_view name) : name_(name) {}
  Program& form(bool shadows);

 private:
  std::string name_;
  std::array<std::unique_ptr<Program>, 2> forms_;
};

inline glm::vec3 rgb(const Color& c) {
  return {c.r, c.g, c.b};
}
inline glm::vec4 rgba(const Color& c) {
  return {c.r, c.g, c.b, c.a};
}

}  // namespace pf
