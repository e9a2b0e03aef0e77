// Light that enters a translucent half-space at one point and leaves at another: the dipole
// diffusion approximation.  [Jensen2001, eq. 4; JensenBuhler2002]
#pragma once

#include "renderer/scene.h"

#include <array>

namespace renderer::diffusion {

/// The kernel of one colour channel: two sources, one below the surface and its mirror image above.
/// A channel that does not scatter has alpha = 0 and reflects nothing.
struct Dipole {
    double alpha = 0;     ///< reduced albedo sigma_s' / sigma_t', 0..1
    double sigma_tr = 0;  ///< effective transport coefficient, 1/mm; 0 without absorption
    double z_real = 1;    ///< depth of the real source: one transport mean free path, mm
    double z_virtual = 1; ///< height of its image, mm
};

/// A = (1 + F_dr) / (1 - F_dr): how much the boundary holds back; exactly 1 when eta is 1.
double boundary_mismatch(double eta);

/// The kernels of red, green and blue.
/// Errors: EXPECTS coefficients that are not negative and an index above 0.
std::array<Dipole, 3> dipoles(const Medium& medium);

/// R_d(r): exitant flux per area over incident flux, at the distance r >= 0.  1/mm^2; finite at 0.
double diffuse_reflectance(const Dipole& dipole, double r);

/// Integral of R_d over an infinite plane: the diffuse albedo of a half-space, 0..1.
double plane_total(const Dipole& dipole);

/// Integral of R_d over a sphere's surface with distances along chords: what one point of the
/// sphere receives when all of it is lit alike. Units: `radius` in mm, above 0.
double sphere_total(const Dipole& dipole, double radius);

/// How R_d scales irradiance of degree l on a sphere (Funk-Hecke): 2 pi int R_d(r) P_l(cos) r dr
/// over all chords r, by quadrature; degree 0 is the sphere's total.
/// Units: `radius` in mm, above 0; l >= 0.
double sphere_eigenvalue(const Dipole& dipole, double radius, int l);

/// Mean square distance that light travels along the plane before it leaves, mm^2: the integral of
/// r^2 R_d over that of R_d.  Infinite without absorption; 0 without scattering.
double mean_square_radius(const Dipole& dipole);

} // namespace renderer::diffusion
