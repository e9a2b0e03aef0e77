// What every light sees of the body, surface behind surface: depth maps.  [Green2004]
//
// A far light looks at a square around the bounding sphere, along parallel rays; a near one at the
// six faces of a cube around itself, with half as many texels along an edge.  Depths are linear, in
// mm.  Shaders read them with light_views.glsl and light_maps.glsl.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/buffer.h"
#include "renderer/gpu/program.h"
#include "renderer/gpu/target.h"
#include "renderer/gpu/vertex_array.h"
#include "renderer/scene.h"
#include "renderer/shading/surface.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace renderer::light_maps {

class LightMaps {
  public:
    /// `layers` surfaces are kept behind each other (depth peeling); 1 is a plain depth map.
    /// Errors: a map of less than 1 texel, or beyond the device's textures.
    static Expected<LightMaps>
    prepare(std::shared_ptr<const shading::Surface> surface, int resolution, int layers);

    /// Texels along an edge from the next `fill` on.
    void set_resolution(int resolution) { resolution_ = resolution; }

    /// Draws the body as the scene's lights see it.
    /// Errors: as above.  EXPECTS what `light_setup` checks.
    Expected<void> fill(const Scene& scene);

    /// The map of a light, at the last `fill`: face after face, in each the nearest surface first;
    /// texels hold depths, positive where the light enters the material, negative where it leaves,
    /// 0 where there is nothing.
    const gpu::LayeredMap& of_light(std::size_t light) const { return maps_[light]; }

    /// Makes the maps the textures from unit 0 on, and their views uniform block 1.
    void bind() const;

    /// The views alone, for a shader that reads maps made from these.
    void bind_views() const { views_.bind_uniform_block(1); }

    /// What a reading shader has to be compiled with, and its shared part.
    std::string defines() const;
    static std::vector<gpu::ShaderPart> shader_parts();

    std::size_t bytes_per_light() const;
    int passes_per_light() const;

  private:
    LightMaps(std::shared_ptr<const shading::Surface> surface,
              gpu::Program linear_pass,
              gpu::Program pass,
              gpu::LayeredMap first,
              int layers);

    Expected<void> make_room(const Scene& scene);
    void draw(const Scene& scene, int light);

    std::shared_ptr<const shading::Surface> surface_;
    gpu::Program linear_pass_; ///< depths from the vertices: faster
    gpu::Program pass_;        ///< depths from the fragments
    gpu::VertexArray vertex_array_;
    gpu::Buffer pass_block_;
    gpu::Buffer views_;
    std::vector<gpu::LayeredMap> maps_;
    int resolution_;
    int layers_;
};

} // namespace renderer::light_maps
