// How much of the light from a direction enters a body at each surface sample.  [Jensen2001]
#pragma once

#include "renderer/diffusion/surface_samples.h"
#include "renderer/geometry/ray_scene.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace renderer::diffusion {

/// Keeps the samples' normals and where rays leave from; may be asked from several threads at once.
class Exposure {
  public:
    /// Errors: as RayScene; EXPECTS eta > 0.
    Exposure(const geometry::Mesh& mesh, const SurfaceSamples& samples, double eta);

    /// V (N.s)+ Ft(eta, N.s) of `sample`: irradiance below the boundary for unit irradiance across
    /// the light's way.  V is 0 where the body itself stands before the light.
    /// Units: `to_light` unit length, in the mesh's axes.
    double operator()(std::size_t sample, glm::dvec3 to_light) const;

    std::size_t size() const { return normals_.size(); }

  private:
    double eta_;
    geometry::RayScene scene_;
    std::vector<glm::dvec3> normals_;
    std::vector<glm::vec3> origins_; // scene coordinates
};

} // namespace renderer::diffusion
