// Rays by renderer/geometry, and the grid that spares them.
#include "renderer/reference/mesh_body.h"

#include "renderer/geometry/crossings.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/reference/clearance.h"
#include "renderer/reference/sunward_depth.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace renderer::reference {

namespace {

// Scene units are diameters: crossings nearer than 1e-6 to an origin are not seen, so a new ray
// starts twice as far from the surface it has met.
constexpr double surface_offset = 2e-6;

constexpr float nearest = 1e-6f;

class MeshTracer final : public BodyTracer {
  public:
    MeshTracer(const geometry::RayScene& scene, const Clearance& clearance)
        : scene_(scene), clearance_(clearance), tracer_(scene) {}

    /// Who looks whether a ray meets the body and then follows it asks twice: traced once.
    std::span<const Stretch> along(glm::dvec3 point, glm::dvec3 direction, Side side) override {
        if (point == last_point_ && direction == last_direction_ && side == last_side_)
            return stretches_;
        last_point_ = point;
        last_direction_ = direction;
        last_side_ = side;
        stretches_.clear();
        for (const auto& [begin, end] : tracer_.from_point(point, direction, side))
            stretches_.push_back({begin, end});
        return stretches_;
    }

    /// That nothing is met proves nothing of a point that rounding or a sharp edge has put on the
    /// surface's other side: one end must be known to be inside, and neither outside, so that a
    /// path that has got out unseen is found out.
    bool is_clear(glm::dvec3 point, glm::dvec3 direction, double length) override {
        const glm::vec3 origin = scene_from(point), along(direction);
        const auto far = static_cast<float>(length / scene_.model_per_scene());
        if (far < clearance_.at(origin))
            return !clearance_.is_surely_outside(origin);
        const glm::vec3 end = origin + far * along;
        return !clearance_.is_surely_outside(end) &&
               (clearance_.is_surely_inside(end) || clearance_.is_surely_inside(origin)) &&
               !scene_.meets(origin, along, 0, far + nearest);
    }

    /// A needle's normal is what rounding left of it: it is turned to the side that the ray says,
    /// and is the ray's own direction where nothing is left.
    glm::dvec3 normal(double distance) override {
        const bool leaving =
            std::ranges::any_of(stretches_, [&](const Stretch& s) { return s.end == distance; });
        const glm::dvec3 ahead = leaving ? last_direction_ : -last_direction_;
        const auto& [a, b, c] = scene_.triangles()[tracer_.triangle_at(distance)];
        const auto& positions = scene_.positions();
        const glm::dvec3 p(positions[a]), q(positions[b]), r(positions[c]);
        const glm::dvec3 n = glm::cross(q - p, r - p);
        const double length = glm::length(n);
        if (length == 0)
            return ahead;
        return glm::dot(n, ahead) < 0 ? -n / length : n / length;
    }

    double clearance(glm::dvec3 point) override {
        return scene_.model_per_scene() * static_cast<double>(clearance_.at(scene_from(point)));
    }

  private:
    glm::vec3 scene_from(glm::dvec3 point) const {
        return glm::vec3(scene_.scene_from_model(point));
    }

    const geometry::RayScene& scene_;
    const Clearance& clearance_;
    geometry::InteriorTracer tracer_;
    glm::dvec3 last_point_{}, last_direction_{}; // no direction is zero
    Side last_side_ = Side::Unknown;
    std::vector<Stretch> stretches_;
};

class MeshBody final : public Body {
  public:
    explicit MeshBody(const geometry::Mesh& mesh) : scene_(mesh), clearance_(scene_) {}

    std::unique_ptr<BodyTracer> tracer() const override {
        return std::make_unique<MeshTracer>(scene_, clearance_);
    }

    double offset() const override { return surface_offset * scene_.model_per_scene(); }

    std::shared_ptr<const SunwardDepth> sunward_depth(glm::dvec3 to_light) const override {
        const std::lock_guard lock(depths_in_use_);
        const auto known = std::ranges::find(depths_, to_light, &Depth::first);
        if (known != depths_.end())
            return known->second;
        depths_.emplace_back(to_light,
                             std::make_shared<SunwardDepth>(scene_, clearance_, to_light));
        return depths_.back().second;
    }

  private:
    using Depth = std::pair<glm::dvec3, std::shared_ptr<const SunwardDepth>>;

    geometry::RayScene scene_;
    Clearance clearance_;
    mutable std::mutex depths_in_use_;
    mutable std::vector<Depth> depths_;
};

} // namespace

std::unique_ptr<Body> make_mesh_body(const geometry::Mesh& mesh) {
    return std::make_unique<MeshBody>(mesh);
}

} // namespace renderer::reference
