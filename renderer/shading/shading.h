// What every method's shaders share: the uniform block of shading.glsl, how it is filled, and the
// programs that read it.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/buffer.h"
#include "renderer/gpu/program.h"
#include "renderer/gpu/vertex_array.h"
#include "renderer/scene.h"
#include "renderer/shading/attenuation.h"
#include "renderer/shading/lighting.h"
#include "renderer/shading/surface.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace renderer::shading {

/// A method's own shaders; shading.glsl stands before both, surface.glsl before the vertex shader.
struct ShaderSource {
    std::string defines; ///< lines before all of it
    std::vector<gpu::ShaderPart> vertex;
    std::vector<gpu::ShaderPart> fragment;
};

/// Draws a surface with a method's shaders, whatever the number and kind of lights.
class SurfaceShader {
  public:
    /// Compiles for one directional light.  Errors: the driver's log.
    static Expected<SurfaceShader> prepare(std::shared_ptr<const Surface> surface,
                                           const Attenuation& attenuation,
                                           ShaderSource source);

    /// The surface's vertex array, to be fed with what a method adds.
    gpu::VertexArray& vertex_array() { return vertex_array_; }

    const Surface& surface() const { return *surface_; }

    /// Makes ready for the scene's lights; a setup that is new is compiled.  To be called before
    /// `draw`.  Errors: those of `light_setup`, the driver's log.
    Expected<void> adapt(const Scene& scene);

    /// Fills the block and draws.
    void draw(const Scene& scene);

  private:
    SurfaceShader(std::shared_ptr<const Surface> surface,
                  const Attenuation& attenuation,
                  ShaderSource source);

    Expected<void> compile(const LightSetup& setup);

    std::shared_ptr<const Surface> surface_;
    Attenuation attenuation_;
    ShaderSource source_;
    LightSetup setup_;
    std::map<LightSetup, gpu::Program> programs_;
    gpu::VertexArray vertex_array_;
    gpu::Buffer block_;
};

} // namespace renderer::shading
