// Points that stand for a surface, each with its share of the area: where irradiance is taken
// before it is spread.  [JensenBuhler2002]
#pragma once

#include "renderer/geometry/mesh.h"
#include "renderer/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace renderer::diffusion {

/// Positions, normals and areas in the mesh's own units; the areas add up to the surface.
struct SurfaceSamples {
    std::vector<glm::dvec3> positions; ///< on the surface: where light is taken
    std::vector<glm::dvec3> centroids; ///< of each one's area: where its light is spread from
    std::vector<glm::dvec3> normals;   ///< of the smooth surface; zero where there is none
    std::vector<double> areas;
    double spacing = 0;        ///< typical distance between neighbours
    bool undersampled = false; ///< the wanted spacing would have taken more samples than allowed
};

struct SamplingOptions {
    double spacing = 1; ///< at most this, in the mesh's units
    std::size_t most_samples = 4'000'000;
    std::uint64_t seed = 1; ///< of the order in which candidates are visited
};

/// The same matter measured in another unit of length: coefficients per model unit.
/// Units: `mm_per_unit` above 0.
Medium in_model_units(const Medium& medium, double mm_per_unit);

/// One transport mean free path 1 / sigma_t' of the densest channel: what samples must not be
/// farther apart than for the dipole's core not to fall between them.  Infinite for empty space.
double wanted_spacing(const Medium& medium);

/// The mesh's vertices with a third of the triangles around each.
SurfaceSamples vertex_samples(const geometry::Mesh& mesh);

/// Points at least a disk's radius apart (0.65 of the spacing) and nowhere farther from the next
/// than that, in an order drawn from the seed; each with the area nearest to it on its side of the
/// sheet. Deterministic.
SurfaceSamples poisson_samples(const geometry::Mesh& mesh, const SamplingOptions& options);

/// The vertices when no edge is longer than the spacing, else Poisson-disk points.  When more than
/// `most_samples` would be needed, as many are spread evenly and the result says `undersampled`.
/// Errors: EXPECTS spacing > 0, most_samples >= 1 and a mesh with area.
SurfaceSamples sample_surface(const geometry::Mesh& mesh, const SamplingOptions& options);

} // namespace renderer::diffusion
