// A fragment shader run once for every pixel of what is drawn into: filters on pictures.
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

class ScreenPass {
  public:
    /// Errors: the driver's log.
    static Expected<ScreenPass> link(std::span<const ShaderPart> fragment);

    /// Writes the first output over every pixel of the viewport: nothing is blended, encoded or
    /// compared with depth on the way.  `gl_FragCoord` counts from the frame buffer's corner.
    void run() const;

    /// The same within a rectangle of the bound frame buffer.
    void run(const PixelRectangle& rectangle) const;

  private:
    explicit ScreenPass(Program program);

    Program program_;
    Object array_; ///< without inputs: the corners come from their numbers
};

} // namespace renderer::gpu
