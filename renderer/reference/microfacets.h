// A rough dielectric: Fresnel on microfacets whose normals follow the GGX distribution.
// [Walter2007]
//
// Directions point away from the surface; `out` is where the path comes from, `in` where it goes
// on, on either side.  Weights are those of light's power, without the squared index by which
// radiance is compressed in the denser medium: a path that begins and ends outside passes as often
// in as out.  Light that other facets hide is not lost: the walk lets it meet the surface again,
// from anywhere on its side, which keeps all of it but is not the exact course among the facets.
#pragma once

#include <glm/vec3.hpp>

#include <optional>

namespace renderer::reference {

/// The surface where a path meets it.
struct RoughSurface {
    glm::dvec3 normal; ///< unit, on the side of `out`
    double alpha = 0.3;
    double index = 1; ///< far side over near side
};

struct Scattered {
    glm::dvec3 direction; ///< unit
    double unhidden = 0;  ///< value over density: the share that no other facet hides
};

/// A direction drawn from `density`; nothing when the facet sends the path to the side it is not
/// on.
std::optional<Scattered>
sample_rough(const RoughSurface& surface, glm::dvec3 out, double u1, double u2, double u3);

/// Per steradian of `in`.
double rough_density(const RoughSurface& surface, glm::dvec3 out, glm::dvec3 in);

/// The scattered power per steradian and unit power: BSDF times cosine of `in`.
double rough_value(const RoughSurface& surface, glm::dvec3 out, glm::dvec3 in);

} // namespace renderer::reference
