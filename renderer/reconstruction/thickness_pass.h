// Thickness toward every light at every vertex, reconstructed on the GPU when a light moves.
// [SHSS, eq. 2]
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/buffer.h"
#include "renderer/gpu/vertex_array.h"
#include "renderer/gpu/vertex_pass.h"
#include "renderer/scene.h"
#include "renderer/shading/lighting.h"
#include "renderer/shading/surface.h"
#include "renderer/thickness/streams.h"
#include "renderer/thickness/thickness_field.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace renderer::reconstruction {

inline constexpr int most_bands = 6;

/// How much of every band is used; bands behind the last that is not 0 are not fetched.
using BandWeights = std::array<float, most_bands>;

class ThicknessPass {
  public:
    /// Keeps the first `bands` bands of `field` ready; each is sent to the GPU when it is used.
    /// Errors: a field of another mesh.
    static Expected<ThicknessPass> prepare(std::shared_ptr<const shading::Surface> surface,
                                           const thickness::ThicknessField& field,
                                           int bands,
                                           thickness::ComponentType type);

    /// Reconstructs for the scene's lights and placement.
    /// Errors: the driver's.  EXPECTS what `light_setup` checks, and bands that were kept.
    Expected<void> run(const Scene& scene, const BandWeights& weights);

    /// The thickness of the last run: mm, a row of one float for each light to a vertex.
    const gpu::Buffer& thickness() const { return *thickness_; }

    /// Of the coefficients on the GPU, to the nearest, with the ranges of their blocks.
    std::size_t bytes_per_vertex() const;

    std::size_t bytes_per_light() const; ///< of uniforms, at the last run

  private:
    /// One program for each number of bands and setup of lights.
    using Key = std::pair<int, shading::LightSetup>;

    ThicknessPass(std::shared_ptr<const shading::Surface> surface,
                  std::vector<thickness::Stream> kept);

    void send_bands(int bands);
    Expected<const gpu::VertexPass*> program(int bands, const shading::LightSetup& setup);

    std::shared_ptr<const shading::Surface> surface_;
    std::vector<thickness::Stream> kept_; ///< their bytes are dropped when they have been sent
    std::vector<gpu::Buffer> streams_;
    std::size_t blocks_ = 0;                 ///< 0 for coefficients that need no ranges
    std::optional<gpu::Buffer> ranges_;      ///< of all kept bands
    std::map<int, gpu::VertexArray> inputs_; ///< by number of bands
    std::map<Key, gpu::VertexPass> programs_;
    std::optional<gpu::Buffer> uniforms_;
    std::optional<gpu::Buffer> thickness_;
    std::size_t lights_ = 1;
};

} // namespace renderer::reconstruction
