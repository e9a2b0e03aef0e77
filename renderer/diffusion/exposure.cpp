// Shadow rays from surface samples.
#include "renderer/diffusion/exposure.h"

#include "renderer/contract.h"
#include "renderer/diffusion/fresnel.h"

#include <glm/geometric.hpp>

namespace renderer::diffusion {

namespace {

// Rays start this far above the surface, in diameters of the body: off the triangles around them,
// and over the horizon that flat triangles put a little too high on a smooth body.
constexpr double lift = 1e-4;

} // namespace

Exposure::Exposure(const geometry::Mesh& mesh, const SurfaceSamples& samples, double eta)
    : eta_(eta), scene_(mesh), normals_(samples.normals) {
    EXPECTS(eta > 0);
    for (std::size_t q = 0; q < normals_.size(); ++q)
        origins_.emplace_back(scene_.scene_from_model(samples.positions[q]) + lift * normals_[q]);
}

double Exposure::operator()(std::size_t sample, glm::dvec3 to_light) const {
    const double cosine = glm::dot(normals_[sample], to_light);
    if (!(cosine > 0) || scene_.is_occluded(origins_[sample], glm::vec3(to_light), 0))
        return 0;
    return cosine * (1 - fresnel_reflectance(cosine, eta_));
}

} // namespace renderer::diffusion
