// Some of a mesh's vertices, evenly spread, that stand for all of its surface.
#pragma once

#include "renderer/geometry/mesh.h"
#include "renderer/thickness/thickness_field.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace renderer::thickness {

struct SurfaceSample {
    int bands = 0;                     ///< of the coefficients
    std::vector<glm::dvec3> positions; ///< model axes and units
    std::vector<glm::dvec3> normals;   ///< unit
    std::vector<double> shares;        ///< of the surface, by the vertex's own triangles
    std::vector<float> coefficients;   ///< bands^2 to a vertex, model units

    std::size_t size() const { return positions.size(); }
};

/// Every so many vertices one, at most `most` of them; vertices without a normal are left out.  In
/// Morton order, as models are loaded, neighbours in the row are neighbours on the surface, and the
/// sample is spread evenly.
/// Errors: EXPECTS a field of the mesh.
SurfaceSample
sample_surface(const geometry::Mesh& mesh, const ThicknessField& field, std::size_t most = 2048);

/// Thickness of sample `i` with 1, 2, ... bands, unclamped: `thickness` has as many elements as
/// there are bands, `basis` y(L) of all of them.
void thickness_by_bands(const SurfaceSample& sample,
                        std::size_t i,
                        std::span<const double> basis,
                        std::span<double> thickness);

} // namespace renderer::thickness
