// From double positions in model units to float positions in the unit sphere.
#include "renderer/shading/surface.h"

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace renderer::shading {

namespace {

gpu::Buffer object_positions(const geometry::Mesh& mesh, const geometry::BoundingSphere& sphere) {
    std::vector<glm::vec3> positions;
    positions.reserve(mesh.positions.size());
    for (const auto& position : mesh.positions)
        positions.emplace_back((position - sphere.centre) / sphere.radius);
    return gpu::Buffer::holding<glm::vec3>(positions);
}

gpu::Buffer object_normals(const geometry::Mesh& mesh) {
    std::vector<glm::vec3> normals;
    normals.reserve(mesh.positions.size());
    for (const auto& normal : geometry::vertex_normals(mesh))
        normals.emplace_back(normal);
    return gpu::Buffer::holding<glm::vec3>(normals);
}

} // namespace

Surface::Surface(const geometry::Mesh& mesh)
    : model_sphere_(geometry::bounding_sphere(mesh)), vertex_count_(mesh.positions.size()),
      positions_(object_positions(mesh, model_sphere_)), normals_(object_normals(mesh)),
      triangles_(gpu::Buffer::holding<geometry::Triangle>(mesh.triangles)) {}

Expected<std::shared_ptr<const Surface>> Surface::upload(const geometry::Mesh& mesh) {
    if (mesh.triangles.empty())
        return tl::make_unexpected("a mesh without triangles, expected something to draw");
    for (const auto& triangle : mesh.triangles)
        for (const auto vertex : triangle)
            if (vertex >= mesh.positions.size())
                return tl::make_unexpected(fmt::format("a triangle names vertex {}, expected 0..{}",
                                                       vertex, mesh.positions.size() - 1));
    if (const double radius = geometry::bounding_sphere(mesh).radius; !(radius > 0))
        return tl::make_unexpected(
            fmt::format("a mesh of radius {}, expected a positive extent", radius));
    return std::shared_ptr<const Surface>(new Surface(mesh));
}

gpu::VertexArray Surface::vertex_array() const {
    gpu::VertexArray array;
    array.feed(0, positions_, {.components = 3});
    array.feed(1, normals_, {.components = 3});
    array.set_triangles(triangles_);
    return array;
}

glm::dmat4 Surface::world_from_object(const Placement& placement) const {
    const glm::dmat4 one(1);
    return placement.world_from_model * glm::translate(one, model_sphere_.centre) *
           glm::scale(one, glm::dvec3(model_sphere_.radius));
}

} // namespace renderer::shading
