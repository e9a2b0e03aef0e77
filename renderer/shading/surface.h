// A mesh in video memory, shared by all methods that draw it.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"
#include "renderer/gpu/buffer.h"
#include "renderer/gpu/vertex_array.h"
#include "renderer/scene.h"

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <memory>

namespace renderer::shading {

/// Positions live in object space: the model recentred on its bounding sphere and scaled to radius
/// 1, in double before they become float, so that neither distance nor unit costs digits.
class Surface {
  public:
    /// Errors: a mesh without triangles, an index beyond its vertices, no extent.
    static Expected<std::shared_ptr<const Surface>> upload(const geometry::Mesh& mesh);

    /// A vertex array fed with positions at location 0 and normals at location 1.
    gpu::VertexArray vertex_array() const;

    glm::dmat4 world_from_object(const Placement& placement) const;

    const geometry::BoundingSphere& model_sphere() const { return model_sphere_; }

    std::size_t vertex_count() const { return vertex_count_; }

    /// Of positions, normals and triangles.
    std::size_t bytes() const { return positions_.bytes() + normals_.bytes() + triangles_.bytes(); }

  private:
    explicit Surface(const geometry::Mesh& mesh);

    geometry::BoundingSphere model_sphere_;
    std::size_t vertex_count_;
    gpu::Buffer positions_;
    gpu::Buffer normals_;
    gpu::Buffer triangles_;
};

} // namespace renderer::shading
