// What happens to light at the surface: nothing (matched), a polished dielectric, or a rough one.
#pragma once

#include <glm/vec3.hpp>

#include <optional>
#include <string_view>

namespace renderer::reference {

enum class BoundaryKind {
    Matched, ///< no refraction, whatever the medium's index: light passes straight
    Smooth,  ///< Fresnel's reflection and Snell's refraction
    Rough    ///< the same on microfacets (renderer/reference/microfacets.h)
};

struct Boundary {
    BoundaryKind kind = BoundaryKind::Matched;
    double roughness = 0.3; ///< GGX alpha of a rough boundary, 0.1..1
};

std::optional<BoundaryKind> boundary_kind(std::string_view name); ///< "matched", "smooth", "rough"
std::string_view name_of(BoundaryKind kind);

/// Fresnel reflectance of unpolarised light that meets the surface at `cosine` in [0, 1] from its
/// normal, `index` being that of the far side over that of the near side: exactly 0 for index 1,
/// exactly 1 beyond the critical angle.
double fresnel(double cosine, double index);

/// Mean of `fresnel` over diffuse light, weighted by the cosine.
double diffuse_fresnel(double index);

/// `direction` behind the surface whose unit `normal` faces where it comes from; nothing on total
/// reflection.  Index 1 returns the direction bit for bit.
std::optional<glm::dvec3> refracted(glm::dvec3 direction, glm::dvec3 normal, double index);

glm::dvec3 reflected(glm::dvec3 direction, glm::dvec3 normal);

} // namespace renderer::reference
