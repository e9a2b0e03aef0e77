// Sets of directions that stand for the whole sphere, each with its share of solid angle.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace renderer::harmonics {

/// A quadrature rule: the integral of f over the sphere is about sum weights[j] f(directions[j]).
struct DirectionSet {
    std::vector<glm::dvec3> directions; ///< unit vectors
    std::vector<double> weights;        ///< steradians; they add up to 4 pi
};

/// Evenly spread, equal weights: z_i = 1 - (2i+1)/N, longitudes a golden angle apart, the whole
/// set turned by one rotation drawn from `rotation_seed`, which keeps it off the axes of meshes.
/// Errors: EXPECTS count >= 1.
DirectionSet fibonacci_directions(int count, std::uint64_t rotation_seed);

/// Gauss-Legendre in cos(theta) times uniform longitude: exact for all polynomials on the sphere up
/// to `exact_degree`; ceil((t+1)/2) * (t+1) directions.
/// Errors: EXPECTS exact_degree >= 0.
DirectionSet gauss_directions(int exact_degree);

} // namespace renderer::harmonics
