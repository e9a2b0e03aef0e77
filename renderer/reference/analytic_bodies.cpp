// Bodies that need no mesh: transport can be tested apart from tracing.
#include "renderer/contract.h"
#include "renderer/reference/body.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace renderer::reference {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// In units of the mean free path or the radius, which is what these bodies are measured in: nearer
// to the surface than this, a point is on it.
constexpr double touching = 1e-10;

/// For bodies that a ray is inside of once at most.
class ConvexTracer : public BodyTracer {
  public:
    std::span<const Stretch> along(glm::dvec3 point, glm::dvec3 direction, Side) final {
        point_ = point;
        direction_ = direction;
        const auto [begin, end] = meet(point, direction);
        stretch_ = {begin < touching ? 0.0 : begin, end};
        const bool leaves_at_once = end < touching;
        return {&stretch_, leaves_at_once || begin >= end ? 0u : 1u};
    }

    bool is_clear(glm::dvec3 point, glm::dvec3 direction, double length) final {
        const auto [begin, end] = meet(point, direction);
        return begin < touching && length < end;
    }

    glm::dvec3 normal(double distance) final { return normal_at(point_ + distance * direction_); }

  protected:
    /// Where the line is inside; begin > end when nowhere.
    virtual Stretch meet(glm::dvec3 point, glm::dvec3 direction) const = 0;

    /// Outward, at a point of the surface.
    virtual glm::dvec3 normal_at(glm::dvec3 point) const = 0;

  private:
    glm::dvec3 point_{}, direction_{}; // of the last question
    Stretch stretch_;
};

class SlabTracer final : public ConvexTracer {
  public:
    explicit SlabTracer(double thickness) : thickness_(thickness) {}

    double clearance(glm::dvec3 point) override {
        return std::max(0.0, std::min(-point.z, thickness_ + point.z));
    }

  protected:
    Stretch meet(glm::dvec3 point, glm::dvec3 direction) const override {
        const double z = std::abs(point.z) < touching ? 0 : point.z;
        if (direction.z == 0)
            return z <= 0 && z >= -thickness_ ? Stretch{0, infinity} : Stretch{1, 0};
        const double top = -z / direction.z;
        const double bottom = (-thickness_ - z) / direction.z;
        return {std::min(top, bottom), std::max(top, bottom)};
    }

    glm::dvec3 normal_at(glm::dvec3 point) const override {
        return {0, 0, 2 * point.z > -thickness_ ? 1 : -1};
    }

  private:
    double thickness_;
};

class SphereTracer final : public ConvexTracer {
  public:
    explicit SphereTracer(double radius) : radius_(radius) {}

    double clearance(glm::dvec3 point) override {
        return std::max(0.0, radius_ - glm::length(point));
    }

  protected:
    Stretch meet(glm::dvec3 point, glm::dvec3 direction) const override {
        const double b = glm::dot(point, direction);
        const glm::dvec3 nearest = point - b * direction;
        const double square = radius_ * radius_ - glm::dot(nearest, nearest);
        if (square <= 0)
            return {1, 0};
        const double half = std::sqrt(square);
        return {-b - half, -b + half};
    }

    glm::dvec3 normal_at(glm::dvec3 point) const override { return glm::normalize(point); }

  private:
    double radius_;
};

template <class Tracer>
class AnalyticBody final : public Body {
  public:
    explicit AnalyticBody(double size) : size_(size) {}

    std::unique_ptr<BodyTracer> tracer() const override { return std::make_unique<Tracer>(size_); }

    double offset() const override { return 0; }

  private:
    double size_;
};

} // namespace

std::shared_ptr<const SunwardDepth> Body::sunward_depth(glm::dvec3) const {
    return nullptr;
}

double covered_by(std::span<const Stretch> stretches) {
    double length = 0;
    for (const auto& [begin, end] : stretches)
        length += end - begin;
    return length;
}

double interior_length(BodyTracer& tracer, glm::dvec3 point, glm::dvec3 direction, Side side) {
    return covered_by(tracer.along(point, direction, side));
}

std::unique_ptr<Body> make_slab(double thickness) {
    EXPECTS(thickness > 0);
    return std::make_unique<AnalyticBody<SlabTracer>>(thickness);
}

std::unique_ptr<Body> make_sphere(double radius) {
    EXPECTS(radius > 0);
    return std::make_unique<AnalyticBody<SphereTracer>>(radius);
}

} // namespace renderer::reference
