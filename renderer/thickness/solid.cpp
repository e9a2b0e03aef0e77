// Openings are covered for the rays, and cost nothing where there are none.
#include "renderer/thickness/solid.h"

#include "renderer/thickness/traceable.h"

namespace renderer::thickness {

Expected<std::shared_ptr<const Solid>> Solid::of(const geometry::Mesh& mesh) {
    const auto covered = covered_solid(mesh);
    if (!covered)
        return tl::unexpected(covered.error());
    auto solid = std::make_shared<const Solid>(*covered);
    if (auto outward = check_components_face_outward(solid->scene()); !outward)
        return tl::unexpected(outward.error());
    return solid;
}

Solid::Solid(const geometry::CoveredMesh& covered)
    : scene_(covered.mesh), vertices_(covered.own_vertices) {
    if (covered.own_triangles < covered.mesh.triangles.size())
        interior_.emplace(scene_, covered.own_triangles);
}

geometry::InteriorTracer Solid::tracer() const {
    return interior_ ? geometry::InteriorTracer(scene_, *interior_)
                     : geometry::InteriorTracer(scene_);
}

} // namespace renderer::thickness
