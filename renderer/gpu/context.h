// OpenGL 4.5 core without a display, and what the current context says about itself.
//
// Everything else in this room needs some 4.5 context to be current on the calling thread: the one
// made here, or a window's.
#pragma once

#include "renderer/expected.h"

#include <string>

namespace renderer::gpu {

/// A context on EGL's surfaceless platform, current on the thread that made it while it lives.
/// It has to outlive every object made in it.
class Context {
  public:
    /// Errors: no EGL library, no surfaceless platform, no device or driver with OpenGL 4.5 core;
    /// the message names what is missing and the packages that bring it.
    static Expected<Context> surfaceless();

    Context(Context&& other) noexcept;
    Context& operator=(Context&& other) noexcept;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context();

  private:
    Context(void* display, void* context) : display_(display), context_(context) {}

    void* display_;
    void* context_;
};

/// The current context's renderer and version as the driver words them, for the manifest.
std::string description();

/// Whether that is one of Mesa's rasterisers in software: then the processor's time is the frame's.
bool draws_on_the_processor();

/// Waits until everything that was asked for is drawn.
void finish();

/// What went wrong in OpenGL since the last call, if anything did; `place` begins the message.
Expected<void> check(const char* place);

} // namespace renderer::gpu
