// What light is met by a point whose surroundings share theirs: normals and irradiance, smoothed as
// far as light spreads in the material.  The reconstruction of [Patro2007]; docs/patro.md
#pragma once

#include "renderer/expected.h"
#include "renderer/smoothing/surface_smoother.h"
#include "renderer/units.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace renderer::smoothing {

/// The diffusion time, mm^2, whose heat kernel (4 t) is as wide as the light's mean square radius,
/// mm^2 (infinite without absorption); at most (diameter/8)^2, beyond which no shape is left.
double diffusion_time(double mean_square_radius, Millimetres diameter);

/// Unit normals smoothed by t (model units squared) and made unit again; where they cancel to less
/// than 1e-3, and at vertices without one, they stay.
Expected<std::vector<glm::dvec3>>
smoothed_normals(SurfaceSmoother& smoother, double t, std::span<const glm::dvec3> normals);

/// Irradiance under light of unit strength, smoothed by t: for each vertex the nine coefficients
/// e_lm = A_l y_lm(N) of its first three bands, so that sum e_lm y_lm(L) is that of a directional
/// light from L.
/// Source: [RamamoorthiHanrahan2001] for A_l = pi, 2 pi/3, pi/4 and for three bands being enough.
Expected<std::vector<double>>
smoothed_irradiance(SurfaceSmoother& smoother, double t, std::span<const glm::dvec3> normals);

inline constexpr int irradiance_bands = 3;

} // namespace renderer::smoothing
