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

    void use() const;

  private:
    explicit Program(Object program) : program_(std::move(program)) {}

    Object program_;
};

} // namespace renderer::gpu
