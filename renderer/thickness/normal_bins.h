// Second moments of a mesh's coefficients, apart for each side that its surface faces: from them
// follows, for any light and any eye, what the picture loses with every band that is not used.
#pragma once

#include "renderer/geometry/mesh.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace renderer::thickness {

/// The vertices whose normals are nearest to one of 32 even directions.
struct NormalBin {
    double share = 0;    ///< of the mesh's surface, 0..1
    glm::dvec3 normal{}; ///< unit: mean of the normals in it, model axes; zero in an empty bin
    /// The area-weighted mean of c c^T, lower triangle: element i(i+1)/2 + j is <c_i c_j>, j <= i.
    /// Model units squared.
    std::vector<double> moments;

    bool operator==(const NormalBin&) const = default;
};

struct NormalBins {
    int bands = 0; ///< moments are of the first bands^2 coefficients
    std::vector<NormalBin> bins;

    bool operator==(const NormalBins&) const = default;
};

/// Sorts all vertices into 32 bins.  Those without a normal are in none.  The sums run over
/// vertices in their order, so the result is the same on every machine.
/// Shapes: `coefficients` has bands^2 elements for every vertex, vertex-major.
NormalBins
bin_by_normal(const geometry::Mesh& mesh, std::span<const float> coefficients, int bands);

/// y^T <c c^T> y, the mean square of c.y over the vertices of a bin.
/// Shapes: `y` as long as c.
double mean_square(const NormalBin& bin, std::span<const double> y);

} // namespace renderer::thickness
