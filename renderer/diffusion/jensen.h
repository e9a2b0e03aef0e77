// A body under one light by the dipole itself, nothing precomputed but its samples: the slow twin
// of precomputed transfer.  [Jensen2001; JensenBuhler2002]
#pragma once

#include "renderer/diffusion/exposure.h"
#include "renderer/diffusion/point_tree.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace renderer::diffusion {

struct DipoleOptions {
    double opening = 0.05; ///< solid angle, sr, above which a node of samples is opened
    std::size_t most_samples = 4'000'000;
};

/// Samples of a body and its kernels, kept from light to light.
class DipoleBody {
  public:
    /// Units: `mm_per_unit` tells how long one unit of the mesh is.
    /// Errors: as RayScene; EXPECTS a mesh with area and a medium that extinguishes light.
    DipoleBody(const geometry::Mesh& mesh,
               const Medium& medium,
               double mm_per_unit,
               const DipoleOptions& options = {});

    /// Radiance that leaves every vertex, alike in all directions, under a directional light of
    /// perpendicular irradiance 1 in each channel: (1/pi) sum A R_d E.
    /// Units: `to_light` unit length, in the mesh's axes; 1/sr.
    std::vector<glm::vec3> exit_radiance(glm::dvec3 to_light) const;

    const SurfaceSamples& samples() const { return samples_; }

  private:
    std::vector<glm::dvec3> receivers_;
    SurfaceSamples samples_;
    Exposure exposure_;
    std::array<Dipole, 3> kernels_;
    double opening_;
};

} // namespace renderer::diffusion
