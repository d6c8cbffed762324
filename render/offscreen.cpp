#include "render/offscreen.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "render/gl_objects.hpp"

namespace pf {

struct OffscreenContext::Impl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface surface = EGL_NO_SURFACE;
  std::string tried;

  ~Impl() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    // The display is shared by the process and stays initialised.
  }

  bool failed(const char* platform, const char* what) {
    char code[16];
    std::snprintf(code, sizeof code, "0x%04x", eglGetError());
    tried += std::string(tried.empty() ? "" : "; ") + platform + ": " + what + " (EGL error " + code + ")";
    return false;
  }

  bool make_current() {
    return eglBindAPI(EGL_OPENGL_API) == EGL_TRUE && eglMakeCurrent(display, surface, surface, context) == EGL_TRUE;
  }

  /// One way to a display; true when its context is current.
  bool attempt(const char* platform, EGLDisplay candidate) {
    if (candidate == EGL_NO_DISPLAY) return failed(platform, "no display");
    if (eglInitialize(candidate, nullptr, nullptr) != EGL_TRUE) return failed(platform, "cannot be initialised");
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return failed(platform, "no OpenGL");
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    if (eglChooseConfig(candidate, wanted, &config, 1, &configs) != EGL_TRUE || configs == 0)
      return failed(platform, "no configuration with OpenGL and pixel buffers");
    const EGLint version[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLContext made = eglCreateContext(candidate, config, EGL_NO_CONTEXT, version);
    if (made == EGL_NO_CONTEXT) return failed(platform, "no OpenGL 3.3 core context");
    display = candidate;
    context = made;
    // No surface is needed where EGL_KHR_surfaceless_context is known; a tiny one does elsewhere.
    if (make_current()) return true;
    const EGLint tiny[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    surface = eglCreatePbufferSurface(display, config, tiny);
    if (surface != EGL_NO_SURFACE && make_current()) return true;
    failed(platform, "the context cannot be made current");
    eglDestroyContext(display, context);
    display = EGL_NO_DISPLAY;
    context = EGL_NO_CONTEXT;
    return false;
  }

  bool attempt_devices() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") ||
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device"))
      return failed("device", "not offered");
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (eglQueryDevicesEXT(16, devices, &count) != EGL_TRUE) return failed("device", "no list of devices");
    for (EGLint k = 0; k < count; ++k)
      if (attempt("device", eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[k], nullptr))) return true;
    return false;
  }
};

OffscreenContext::OffscreenContext() : impl_(std::make_unique<Impl>()) {
  const bool platforms = epoxy_has_egl() && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base");
  bool ok = false;
  if (platforms) {
    // A graphics card first, then whatever Mesa has, which is its software renderer at least.
    ok = impl_->attempt_devices();
    if (!ok && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
      ok = impl_->attempt("surfaceless",
                          eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  if (!ok && epoxy_has_egl()) ok = impl_->attempt("default", eglGetDisplay(EGL_DEFAULT_DISPLAY));
  if (ok) return;
  throw std::runtime_error("Pictures cannot be drawn without a display here: EGL gives no OpenGL 3.3 context. Tried " +
                           (impl_->tried.empty() ? std::string("nothing, for libEGL was not found") : impl_->tried) +
                           ". Mesa's libEGL with its software renderer is enough (Debian: libegl1, libgl1-mesa-dri).");
}

OffscreenContext::~OffscreenContext() = default;

void OffscreenContext::make_current() {
  if (!impl_->make_current()) throw std::runtime_error("The off-screen OpenGL context cannot be made current.");
}

/// Draws into multisampled buffers, which read() resolves into plain ones.
struct OffscreenTarget::Impl {
  ViewSize size;
  GLsizei samples = 0;
  gl::Framebuffer draw, resolved;
  gl::Renderbuffer color, depth, plain;
};

OffscreenTarget::OffscreenTarget(ViewSize size, int samples) : impl_(std::make_unique<Impl>()) {
  GLint most = 0, limit = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
  if (size.width <= 0 || size.height <= 0 || size.width > limit || size.height > limit)
    throw std::runtime_error("A picture of " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                             " pixels cannot be drawn here; each side may be 1 to " + std::to_string(limit) + ".");
  const GLsizei used = samples > 1 ? std::min(samples, most) : 0;
  Impl& im = *impl_;
  im.size = size;
  im.samples = used;
  const auto attach = [&](const gl::Renderbuffer& buffer, GLsizei n, GLenum format, GLenum where) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, n, format, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer.name());
  };
  glBindFramebuffer(GL_FRAMEBUFFER, im.draw.name());
  attach(im.color, used, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  attach(im.depth, used, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glBindFramebuffer(GL_FRAMEBUFFER, im.resolved.name());
  attach(im.plain, 0, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  if (!complete || glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("The off-screen framebuffer is incomplete.");
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  bind();
}

OffscreenTarget::~OffscreenTarget() = default;

ViewSize OffscreenTarget::size() const {
  return impl_->size;
}

void OffscreenTarget::bind() {
  glBindFramebuffer(GL_FRAMEBUFFER, impl_->draw.name());
  glViewport(0, 0, impl_->size.width, impl_->size.height);
}

void OffscreenTarget::copy_to(int x, int y, bool drawn_anew) {
  const auto [w, h] = impl_->size;
  const gl::TargetGuard guard;
  GLint shown = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &shown);
  const bool plain = impl_->samples == 0;  // nothing to resolve
  if (drawn_anew && !plain) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, impl_->draw.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, impl_->resolved.name());
    glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, plain ? impl_->draw.name() : impl_->resolved.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(shown));
  glBlitFramebuffer(0, 0, w, h, x, y, x + w, y + h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Image OffscreenTarget::read() {
  const auto [w, h] = impl_->size;
  const gl::TargetGuard guard;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, impl_->draw.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, impl_->resolved.name());
  glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, impl_->resolved.name());
  Image picture(w, h);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, w, h, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels.data());
  picture.flip_rows();
  return picture;
}

}  // namespace pf
