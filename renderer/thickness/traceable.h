// Whether a mesh has an inside at all: what must hold before thickness means anything.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"
#include "renderer/geometry/openings.h"
#include "renderer/geometry/ray_scene.h"

namespace renderer::thickness {

/// The mesh with its openings covered.  Fails unless it has triangles and finite positions, every
/// edge that is not the rim of an opening is run through as often in one sense as in the other, and
/// the volume with its openings covered is positive.
Expected<geometry::CoveredMesh> covered_solid(const geometry::Mesh& mesh);

/// Fails when a component faces inward that is not a cavity in another one.
Expected<void> check_components_face_outward(const geometry::RayScene& scene);

} // namespace renderer::thickness
