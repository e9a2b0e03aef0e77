// A fragment shader run once for every pixel of what is drawn into: filters on pictures.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/object.h"
#include "renderer/gpu/program.h"

#include <span>

namespace renderer::gpu {

class ScreenPass {
  public:
    /// Errors: the driver's log.
    static Expected<ScreenPass> link(std::span<const ShaderPart> fragment);

    /// Writes every pixel of the viewport, without looking at depth.
    void run() const;

  private:
    explicit ScreenPass(Program program);

    Program program_;
    Object array_; ///< without inputs: the corners come from their numbers
};

} // namespace renderer::gpu
