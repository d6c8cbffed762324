#include "render/program.hpp"

#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

namespace pf {

namespace {

GLuint compile(GLenum stage, std::string_view name, std::string_view form) {
  const std::string head = std::string("#version 330 core\n#define ") +
                           (stage == GL_VERTEX_SHADER ? "VERTEX\n" : "FRAGMENT\n") +
                           (form.empty() ? std::string() : "#define " + std::string(form) + "\n") +
                           std::string(shader_source("common")) + "\n#line 1\n";
  const std::string_view body = shader_source(name);
  if (body.empty()) throw std::runtime_error("There is no shader " + std::string(name));
  const GLchar* parts[] = {head.c_str(), body.data()};
  const GLint lengths[] = {static_cast<GLint>(head.size()), static_cast<GLint>(body.size())};
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 2, parts, lengths);
  glCompileShader(shader);
  GLint ok = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  char log[2048] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  throw std::runtime_error("Shader " + std::string(name) + " does not compile: " + log);
}

}  // namespace

Program::Program(std::string_view name, std::string_view form) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, name, form);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, name, form);
  name_ = glCreateProgram();
  glAttachShader(name_, vertex);
  glAttachShader(name_, fragment);
  glLinkProgram(name_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint ok = GL_FALSE;
  glGetProgramiv(name_, GL_LINK_STATUS, &ok);
  if (ok == GL_TRUE) return;
  char log[2048] = "";
  glGetProgramInfoLog(name_, sizeof log, nullptr, log);
  glDeleteProgram(name_);
  throw std::runtime_error("Shader " + std::string(name) + " does not link: " + log);
}

Program::~Program() {
  glDeleteProgram(name_);
}

Program& ReceiverProgram::form(bool shadows) {
  std::unique_ptr<Program>& program = forms_[shadows ? 1 : 0];
  if (!program) program = std::make_unique<Program>(name_, shadows ? "SHADOWS" : "");
  return *program;
}

void Program::use() const {
  glUseProgram(name_);
}

GLint Program::location(const char* uniform) {
  const auto found = locations_.find(std::string_view(uniform));
  if (found != locations_.end()) return found->second;
  return locations_.emplace(uniform, glGetUniformLocation(name_, uniform)).first->second;
}

void Program::set(const char* uniform, int value) {
  glUniform1i(location(uniform), value);
}
void Program::set(const char* uniform, float value) {
  glUniform1f(location(uniform), value);
}
void Program::set(const char* uniform, const glm::vec2& value) {
  glUniform2fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec3& value) {
  glUniform3fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec4& value) {
  glUniform4fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat3& value) {
  glUniformMatrix3fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat4& value) {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace pf
