// Henyey-Greenstein: how much light turns by which angle when it is scattered.
//
//   p(cos) = (1 - g^2) / (4 pi (1 + g^2 - 2 g cos)^(3/2)),  cos = 1 straight on.
//   [HenyeyGreenstein1941]
#pragma once

#include <glm/vec3.hpp>

namespace renderer::reference {

/// Per steradian; integrates to one over the sphere.  `g` within +-0.999.
double henyey_greenstein(double cosine, double g);

/// The cosine whose distribution function is `u` in [0, 1]; within [-1, 1].
/// Two exact forms of one inversion, each where it rounds least: below |g| = 0.5 the one without
/// the division by g (the textbook form errs by 1e-3 in float at g = 1e-4), above it the textbook's
/// (at g = 0.999 the other loses two digits).
double sample_henyey_greenstein(double u, double g);

/// The unit vector at the angle with `cosine` from unit `axis`, turned about it by `turn` in [0, 1)
/// of a circle, to 1e-7 of it.
glm::dvec3 around(glm::dvec3 axis, double cosine, double turn);

/// A unit vector, uniform over the sphere for uniform `u` and `turn` in [0, 1); turned to
/// 1e-7 of a circle.
glm::dvec3 on_sphere(double u, double turn);

} // namespace renderer::reference
