// How much light a thick layer sends back: transport theory's answer for isotropic scattering under
// a smooth surface, without the diffusion approximation.  [Chandrasekhar1960]
#pragma once

namespace renderer {

/// How the light arrives: straight down, or with the same radiance from everywhere.
enum class Incidence { Normal, Diffuse };

/// Share of the arriving light that comes back out of the body of a half-space, what its surface
/// mirrors left aside.  Mediums that scatter in one direction more than in another are meant by
/// their reduced albedo alpha' = sigma_s' / (sigma_a + sigma_s').
/// Ranges: albedo 0..1, index (inside over outside) >= 1; EXPECTS both.  Absolute error < 1e-6.
/// Source: [Chandrasekhar1960, chapter 4] for what the bare half-space does; the surface sends part
///         of that back in, as often as it takes.
double body_reflectance(double albedo, double index, Incidence incidence);

} // namespace renderer
