// A vertex shader run once for every vertex, its outputs kept in a buffer: what depends on the
// light alone is computed when the light moves, not whenever something is drawn.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/buffer.h"
#include "renderer/gpu/object.h"
#include "renderer/gpu/program.h"
#include "renderer/gpu/vertex_array.h"

#include <cstddef>
#include <span>

namespace renderer::gpu {

class VertexPass {
  public:
    /// Errors: the driver's log.
    static Expected<VertexPass> link(std::span<const ShaderPart> vertex,
                                     std::span<const char* const> captured);

    /// Runs over the first `count` rows that `inputs` is fed with, and writes the captured outputs
    /// of vertex after vertex into `rows`, which has to have room for them.
    void run(const VertexArray& inputs, std::size_t count, const Buffer& rows) const;

  private:
    explicit VertexPass(Program program);

    Program program_;
    Object framebuffer_; ///< without attachments: even drawing nothing needs somewhere to draw
};

} // namespace renderer::gpu
