// How thick a body is around every vertex, whatever the light: what a translucency map bakes.
// [BarreBrisebois2011]
#pragma once

#include "renderer/geometry/mesh.h"
#include "renderer/thickness/thickness_field.h"

#include <vector>

namespace renderer::thickness {

/// Mean of the thickness over the directions into the body, weighted by their cosine to -N: in
/// model units, one value a vertex, at least 0.  A translucency map is baked as ambient occlusion
/// with normals turned inward, and ambient occlusion weights by the cosine.  It needs no rays
/// beyond those of the field: the clamped cosine is one factor to a band,
///   (1/pi) sum_l A_l sum_m c_lm y_lm(-N), A = pi, 2 pi/3, pi/4, 0, -pi/24, 0,
/// and bands above the fifth hold at most 1/64 of what little the field leaves out.
/// Errors: a field of another mesh.
Expected<std::vector<double>> local_thickness(const geometry::Mesh& mesh,
                                              const thickness::ThicknessField& field);

} // namespace renderer::thickness
