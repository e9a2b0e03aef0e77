// A fragment shader run once for every pixel of a rectangle.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/object.h"
#include "renderer/gpu/program.h"

#include <span>

namespace renderer::gpu {

/// A rectangle of a frame buffer, pixels from its lower left corner.
struct PixelRectangle {
    int left = 0, bottom = 0;
    int width = 0, height = 0;
};

class PixelPass {
  public:
    /// Errors: the driver's log.
    static Expected<PixelPass> link(std::span<const ShaderPart> fragment);

    /// Writes the first output over what is there, in the bound frame buffer: nothing is blended,
    /// encoded or compared with depth on the way.  `gl_FragCoord` counts from the frame buffer's
    /// corner.
    void run(const PixelRectangle& rectangle) const;

  private:
    explicit PixelPass(Program program);

    Program program_;
    Object no_inputs_;
};

} // namespace renderer::gpu
