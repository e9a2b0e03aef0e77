// Reflection at the smooth boundary between air and a medium, and its hemispherical means.
// [Jensen2001]
#pragma once

namespace renderer::diffusion {

/// Unpolarised Fresnel reflectance for light that meets the boundary from outside.
/// Units: `cosine` of the angle to the normal, 0..1 (below 0 counts as grazing); `eta` inside over
/// outside.  Exactly 0 when eta is 1; 1 beyond the critical angle of eta < 1.
double fresnel_reflectance(double cosine, double eta);

/// Mean reflectance for diffuse light from outside: 2 int_0^1 F(mu) mu dmu.
/// Errors: EXPECTS eta > 0.
double external_diffuse_reflectance(double eta);

/// Mean reflectance F_dr for diffuse light from inside, exact by the identity
/// F_dr = 1 - (1 - F_ext) / eta^2, not the paper's fit; exactly 0 when eta is 1.
double internal_diffuse_reflectance(double eta);

} // namespace renderer::diffusion
