// Bodies whose shape, volume and thickness are known in closed form, as closed meshes.
//
// Every mesh is closed and manifold, its triangles counter-clockwise seen from outside the
// material, its centre at the origin, its vertices on the true surface, so that volume and
// thickness approach the closed forms (renderer/geometry/body_thickness.h) at second order in the
// edge length.
#pragma once

#include "renderer/geometry/mesh.h"

namespace renderer::geometry {

/// Icosphere: an icosahedron whose triangles are split in four `subdivisions` times (0..9).
/// It has 20 * 4^subdivisions triangles.
Mesh sphere(double radius, int subdivisions);

/// Material between two concentric spheres; the inner surface faces the cavity.
/// Errors: EXPECTS 0 < inner_radius < outer_radius.
Mesh shell(double outer_radius, double inner_radius, int subdivisions);

/// Ring around the z axis: a tube of `minor_radius` whose centre line has `major_radius`, in
/// `n_major` cells along the centre line and `n_minor` around the tube (each at least 3).
/// Errors: EXPECTS 0 < minor_radius < major_radius.
Mesh torus(double major_radius, double minor_radius, int n_major, int n_minor);

/// Box of `width` along x, `height` along y and `thickness` along z; n x n cells on the two faces
/// across the thickness.
Mesh slab(double width, double height, double thickness, int n);

/// Box with edges and corners rounded by `radius`, at most the smallest of `half_extents`, which
/// include the rounding; cells of about the longest edge over `n`.
Mesh rounded_box(glm::dvec3 half_extents, double radius, int n);

} // namespace renderer::geometry
