// A vertex and a fragment shader, compiled and linked.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/object.h"

#include <span>
#include <string_view>

namespace renderer::gpu {

/// One file of GLSL.  A shader is several of them in a row: what is shared, then what is its own.
struct ShaderPart {
    std::string_view name; ///< the file's, for messages
    std::string_view text;
};

class Program {
  public:
    /// Compiles `#version 450 core` and the parts in their order.
    /// Errors: the driver's log, and at which of its lines each part begins.
    static Expected<Program> link(std::span<const ShaderPart> vertex,
                                  std::span<const ShaderPart> fragment);

    /// A vertex shader alone, whose outputs `captured` (in this order, without gaps) are written
    /// into a buffer instead of being drawn.  Errors: as above, and outputs there are not.
    static Expected<Program> link_capturing(std::span<const ShaderPart> vertex,
                                            std::span<const char* const> captured);

    void use() const;

  private:
    explicit Program(Object program) : program_(std::move(program)) {}

    Object program_;
};

} // namespace renderer::gpu
