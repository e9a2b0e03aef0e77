// EGL's surfaceless platform, step by step; each step that can fail says what would have helped.
#include "renderer/gpu/context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>
#include <utility>

namespace renderer::gpu {

namespace {

// libepoxy ends the program when it cannot open these, so we look before it does.
bool can_be_opened(const char* library) {
    void* handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
    if (handle != nullptr)
        dlclose(handle);
    return handle != nullptr;
}

tl::unexpected<std::string> no_context(const std::string& reason) {
    return tl::make_unexpected(
        fmt::format("no OpenGL 4.5 without a display: {}; Debian's libegl1, libgl1 and "
                    "libgl1-mesa-dri bring a software renderer",
                    reason));
}

std::string egl_error() {
    return fmt::format("EGL error 0x{:04x}", eglGetError());
}

Expected<EGLDisplay> surfaceless_display() {
    if (!can_be_opened("libEGL.so.1"))
        return no_context("the library libEGL.so.1 cannot be opened");
    if (!can_be_opened("libOpenGL.so.0") && !can_be_opened("libGL.so.1"))
        return no_context("neither libOpenGL.so.0 nor libGL.so.1 can be opened");
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        return no_context("EGL has no driver for its surfaceless platform");
    const EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY)
        return no_context("EGL gives no surfaceless display, " + egl_error());
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        return no_context("the surfaceless display does not start, " + egl_error());
    return display;
}

} // namespace

Expected<Context> Context::surfaceless() {
    const auto display = surfaceless_display();
    if (!display)
        return tl::make_unexpected(display.error());
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE)
        return no_context("EGL knows no desktop OpenGL, " + egl_error());

    constexpr std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                           EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(*display, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0)
        return no_context("no frame buffer configuration for OpenGL, " + egl_error());

    constexpr std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                            4,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            5,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
    const EGLContext context = eglCreateContext(*display, config, EGL_NO_CONTEXT, version.data());
    if (context == EGL_NO_CONTEXT)
        return no_context("the driver has no OpenGL 4.5 core, " + egl_error());
    Context made(*display, context);
    if (eglMakeCurrent(*display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE)
        return no_context("the context cannot be made current, " + egl_error());
    return made;
}

Context::Context(Context&& other) noexcept
    : display_(other.display_), context_(std::exchange(other.context_, nullptr)) {}

Context& Context::operator=(Context&& other) noexcept {
    std::swap(display_, other.display_);
    std::swap(context_, other.context_);
    return *this;
}

// The display stays open: EGL has one per process, and another context may live on it.
Context::~Context() {
    if (context_ == nullptr)
        return;
    if (eglGetCurrentContext() == context_)
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

std::string description() {
    const auto text = [](GLenum name) {
        const auto* value = reinterpret_cast<const char*>(glGetString(name));
        return std::string(value == nullptr ? "unknown" : value);
    };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

bool draws_on_the_processor() {
    const auto driver = description();
    return driver.find("llvmpipe") != driver.npos || driver.find("softpipe") != driver.npos;
}

void finish() {
    glFinish();
}

Expected<void> check(const char* place) {
    const GLenum first = glGetError();
    while (glGetError() != GL_NO_ERROR) {
    }
    if (first == GL_NO_ERROR)
        return {};
    if (first == GL_OUT_OF_MEMORY)
        return tl::make_unexpected(
            fmt::format("{}: OpenGL is out of memory, expected a smaller picture or mesh", place));
    return tl::make_unexpected(
        fmt::format("{}: OpenGL error 0x{:04x} on {}", place, first, description()));
}

} // namespace renderer::gpu
