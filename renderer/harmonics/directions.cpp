// Fibonacci and Gauss product rules over the sphere.
#include "renderer/harmonics/directions.h"

#include "renderer/contract.h"
#include "renderer/harmonics/gauss_legendre.h"
#include "renderer/splitmix.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <numbers>

namespace renderer::harmonics {

namespace {

using std::numbers::pi;

/// Uniform over all rotations: a uniform point on the unit 3-sphere.  [Shoemake1992]
glm::dquat random_rotation(std::uint64_t seed) {
    std::uint64_t state = seed;
    const double u = uniform(state), a = 2 * pi * uniform(state), b = 2 * pi * uniform(state);
    const double p = std::sqrt(1 - u), q = std::sqrt(u);
    return {q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b)};
}

glm::dvec3 from_z_and_longitude(double z, double longitude) {
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    return {r * std::cos(longitude), r * std::sin(longitude), z};
}

} // namespace

DirectionSet fibonacci_directions(int count, std::uint64_t rotation_seed) {
    EXPECTS(count >= 1);
    const glm::dquat rotation = random_rotation(rotation_seed);
    DirectionSet set;
    for (int i = 0; i < count; ++i) {
        const double turns = i / std::numbers::phi;
        const double longitude = 2 * pi * (turns - std::floor(turns));
        const auto direction =
            rotation * from_z_and_longitude(1 - (2.0 * i + 1) / count, longitude);
        set.directions.push_back(glm::normalize(direction));
        set.weights.push_back(4 * pi / count);
    }
    return set;
}

DirectionSet gauss_directions(int exact_degree) {
    EXPECTS(exact_degree >= 0);
    const int longitudes = exact_degree + 1;
    DirectionSet set;
    for (const auto& [x, weight] : gauss_legendre((exact_degree + 2) / 2))
        for (int k = 0; k < longitudes; ++k) {
            set.directions.push_back(from_z_and_longitude(x, 2 * pi * (k + 0.5) / longitudes));
            set.weights.push_back(weight * 2 * pi / longitudes);
        }
    return set;
}

} // namespace renderer::harmonics
