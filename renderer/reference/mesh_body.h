// A closed triangle mesh as a body to walk in.
#pragma once

#include "renderer/geometry/mesh.h"
#include "renderer/reference/body.h"

namespace renderer::reference {

/// `mesh` is closed (renderer/geometry/mesh_repair.h); overlapping parts count once, parts that
/// face inward are cavities.
/// Errors: those of renderer/geometry/ray_scene.h.
std::unique_ptr<Body> make_mesh_body(const geometry::Mesh& mesh);

} // namespace renderer::reference
