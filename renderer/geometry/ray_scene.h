// A mesh that rays can be sent through: Embree's one door.
#pragma once

#include "renderer/geometry/mesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace renderer::geometry {

/// One ray meeting one triangle.
struct Hit {
    float distance = 0;         ///< from the ray's origin, scene units
    std::uint32_t triangle = 0; ///< index into the mesh's triangles
    bool leaving = false;       ///< the ray crosses from the inner to the outer side
    bool grazing = false;       ///< along the triangle, but for rounding: its place is not known
};

/// While it lives, denormal numbers are zero on this thread.  Embree asks every tracing thread for
/// one: denormals cost it a hundred times an ordinary number.
class DenormalsAreZero {
  public:
    DenormalsAreZero();
    ~DenormalsAreZero();
    DenormalsAreZero(const DenormalsAreZero&) = delete;
    DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

  private:
    unsigned before_;
};

/// The mesh in scene coordinates: moved to the centre of its bounding sphere and scaled to unit
/// diameter, both in double, before positions are rounded to the float that rays are traced in.
/// May be asked from several threads at once.
class RayScene {
  public:
    /// Copies what it needs of `mesh`.
    /// Errors: throws std::runtime_error when Embree cannot start; EXPECTS positions that are
    /// finite and not all equal, and triangles that name vertices there are.
    explicit RayScene(const Mesh& mesh);
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    static constexpr std::size_t bundle_size = 64; ///< rays that are followed at once
    using BundleHits = std::array<std::vector<Hit>, bundle_size>;

    /// Every triangle the ray meets farther than `nearest` from its origin, in no order.  A ray
    /// through an edge may meet both neighbours, never neither.  Replaces what `hits` held.
    /// Units: `origin` in scene coordinates, `direction` unit length.
    void
    all_hits(glm::vec3 origin, glm::vec3 direction, float nearest, std::vector<Hit>& hits) const;

    /// The same for several rays in one direction, hits[i] for origins[i]: neighbours share their
    /// way through the tree, and so many take two thirds of the time of single rays.
    /// Errors: EXPECTS at most `bundle_size` origins.
    void all_hits(std::span<const glm::vec3> origins,
                  glm::vec3 direction,
                  float nearest,
                  BundleHits& hits) const;

    /// Whether the ray meets anything farther than `nearest` from its origin.
    /// Units: `origin` in scene coordinates, `direction` unit length.
    bool is_occluded(glm::vec3 origin, glm::vec3 direction, float nearest) const;

    /// Whether the ray meets a triangle between the two distances.
    bool meets(glm::vec3 origin, glm::vec3 direction, float nearest, float farthest) const;

    std::span<const Triangle> triangles() const { return triangles_; }

    std::span<const glm::vec3> positions() const { return positions_; } ///< scene coordinates

    /// How many model units one scene unit is: the diameter of the bounding sphere.
    double model_per_scene() const { return model_per_scene_; }

    glm::dvec3 scene_from_model(glm::dvec3 point) const {
        return (point - centre_) / model_per_scene_;
    }

    glm::dvec3 model_from_scene(glm::dvec3 point) const {
        return centre_ + model_per_scene_ * point;
    }

  private:
    struct Handles;
    glm::dvec3 centre_{};
    double model_per_scene_ = 1;
    std::vector<glm::vec3> positions_;
    std::vector<Triangle> triangles_;
    std::unique_ptr<Handles> handles_;
};

} // namespace renderer::geometry
