// Irradiance by shadow rays, then one gather for each vertex.
#include "renderer/diffusion/jensen.h"

#include "renderer/contract.h"
#include "renderer/diffusion/block_loop.h"

#include <numbers>

namespace renderer::diffusion {

namespace {

constexpr std::size_t samples_per_block = 1024;

SurfaceSamples
samples_of(const geometry::Mesh& mesh, const Medium& per_unit, const DipoleOptions& options) {
    const double spacing = wanted_spacing(per_unit);
    EXPECTS(spacing > 0 && spacing < 1e300); // something there to scatter
    return sample_surface(mesh, {.spacing = spacing, .most_samples = options.most_samples});
}

} // namespace

DipoleBody::DipoleBody(const geometry::Mesh& mesh,
                       const Medium& medium,
                       double mm_per_unit,
                       const DipoleOptions& options)
    : receivers_(mesh.positions),
      samples_(samples_of(mesh, in_model_units(medium, mm_per_unit), options)),
      exposure_(mesh, samples_, medium.index),
      kernels_(dipoles(in_model_units(medium, mm_per_unit))), opening_(options.opening) {}

std::vector<glm::vec3> DipoleBody::exit_radiance(glm::dvec3 to_light) const {
    std::vector<float> irradiance(exposure_.size());
    for_each_block(irradiance.size(), samples_per_block, {}, [&](auto begin, auto end) {
        for (auto q = begin; q < end; ++q)
            irradiance[q] = static_cast<float>(exposure_(q, to_light));
    });
    const PointTree tree(samples_, irradiance, 1);
    const auto spread_light = spread(tree, kernels_, receivers_, opening_);
    std::vector<glm::vec3> radiance;
    for (std::size_t v = 0; v < receivers_.size(); ++v)
        radiance.push_back(
            glm::vec3(spread_light[3 * v], spread_light[3 * v + 1], spread_light[3 * v + 2]) *
            std::numbers::inv_pi_v<float>);
    return radiance;
}

} // namespace renderer::diffusion
