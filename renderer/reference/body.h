// What a walk asks of the body it is in: where a ray is inside, and which way the surface faces.
#pragma once

#include "renderer/geometry/side.h"

#include <glm/vec3.hpp>

#include <memory>
#include <span>

namespace renderer::reference {

using geometry::Side;

/// A stretch of a ray inside the material: distances from the origin, begin < end, which may be
/// infinite.
struct Stretch {
    double begin = 0; ///< exactly 0 when the ray starts inside
    double end = 0;
};

/// The length of all of them, which do not overlap; in the body's units.
double covered_by(std::span<const Stretch> stretches);

/// Asks one body about rays, one at a time; every thread has its own.  Answers depend on the
/// question alone.  Points and lengths are in the body's units, directions are unit vectors.
class BodyTracer {
  public:
    virtual ~BodyTracer() = default;

    /// Every stretch inside the material ahead, nearest first.  Valid until the next question.
    /// `side` is where the asker has come to; the answer starts on the other one only where the
    /// surface says so.
    virtual std::span<const Stretch> along(glm::dvec3 point, glm::dvec3 direction, Side side) = 0;

    /// Whether the next `length` of the ray surely do not meet the surface; false says nothing.
    virtual bool is_clear(glm::dvec3 point, glm::dvec3 direction, double length) = 0;

    /// The unit outward normal at `distance` on the ray that `along` was asked about last, where
    /// one of its stretches begins or ends: against the ray where it begins, along it where it
    /// ends.
    virtual glm::dvec3 normal(double distance) = 0;

    /// No less than 0 and no more than the distance of `point`, inside, from the surface.
    virtual double clearance(glm::dvec3 point) = 0;
};

class SunwardDepth;

/// A closed body; may be shared by threads.
class Body {
  public:
    virtual ~Body() = default;

    /// The body must outlive the tracer.
    virtual std::unique_ptr<BodyTracer> tracer() const = 0;

    /// How far a new ray starts from the surface it has just met, along the normal: what keeps it
    /// on its side.  0 where arithmetic is exact enough.
    virtual double offset() const = 0;

    /// What is known without a ray of the length inside toward a unit direction, made once for each
    /// direction that is asked for; the body must outlive it.  Null where nothing is.
    virtual std::shared_ptr<const SunwardDepth> sunward_depth(glm::dvec3 to_light) const;
};

/// The length of the ray inside the material.
double interior_length(BodyTracer& tracer,
                       glm::dvec3 point,
                       glm::dvec3 direction,
                       Side side = Side::Unknown);

/// Between the planes z = 0 and z = -thickness; infinitely wide.  `thickness` may be infinite: a
/// half-space.
std::unique_ptr<Body> make_slab(double thickness);

/// Around the origin.
std::unique_ptr<Body> make_sphere(double radius);

} // namespace renderer::reference
