// How far light travels under the surface: Burley's normalised diffusion, seen along a line.
// [Christensen2015]
#pragma once

#include "renderer/scene.h"
#include "renderer/units.h"

#include <glm/vec3.hpp>

#include <vector>

namespace renderer::diffusion {

/// The profile's length d in mm, for each channel: R(r) = (e^(-r/d) + e^(-r/3d)) / (8 pi d r) with
/// d = l/s, l the mean free path 1/sigma_t' and s = 1.9 - A + 3.5 (A - 0.8)^2 for the
/// half-space's reflectance A under the dipole.  0 where nothing is met.
glm::dvec3 diffusion_length(const Medium& medium);

/// R integrated over all lines across: (K0(x/d) + K0(x/3d)) / (4 pi d), in 1/mm, x > 0.
double line_profile(double x, double d);

/// The part of the line profile beyond x >= 0: (Ki1(x/d) + 3 Ki1(x/3d)) / (4 pi), 1/2 at 0.  The
/// response behind a straight edge of light, as far as x.
double line_profile_beyond(double x, double d);

/// One sample of a blur along a line: where, in mm, and how much of each channel.
struct DiffusionTap {
    double offset;
    glm::dvec3 weight;
};

/// A blur by the line profile in `count` samples, closer together near the middle, each with what
/// the profile has between its neighbours' half ways; the outermost have the rest.  Weights sum to
/// 1 in every channel.
/// Errors: EXPECTS an odd count of 3 or more.
std::vector<DiffusionTap> diffusion_taps(const glm::dvec3& d, int count);

} // namespace renderer::diffusion
