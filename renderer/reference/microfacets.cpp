// GGX with visible normals.
#include "renderer/reference/microfacets.h"

#include "renderer/reference/boundary.h"
#include "renderer/reference/phase.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer::reference {

namespace {

/// Facets with normal at `cosine` from the surface's, per steradian.
double ggx(double cosine, double alpha) {
    const double a2 = alpha * alpha, d = cosine * cosine * (a2 - 1) + 1;
    return a2 / (std::numbers::pi * d * d);
}

/// The share of facets not hidden in a direction at |cosine| from the normal.
double unshadowed(double cosine, double alpha) {
    const double c2 = cosine * cosine;
    if (c2 == 0)
        return 0;
    return 2 / (1 + std::sqrt(1 + alpha * alpha * (1 - c2) / c2));
}

/// A facet normal as seen from `out`.  [Heitz2018]
glm::dvec3 visible_normal(const RoughSurface& surface, glm::dvec3 out, double u1, double u2) {
    const glm::dvec3 n = surface.normal;
    const glm::dvec3 x = around(n, 0, 0), y = glm::cross(n, x);
    const double alpha = surface.alpha;
    const glm::dvec3 v = glm::normalize(
        glm::dvec3(alpha * glm::dot(out, x), alpha * glm::dot(out, y), glm::dot(out, n)));
    const double flat = v.x * v.x + v.y * v.y;
    const glm::dvec3 t1 =
        flat > 0 ? glm::dvec3(-v.y, v.x, 0) / std::sqrt(flat) : glm::dvec3(1, 0, 0);
    const glm::dvec3 t2 = glm::cross(v, t1);
    const double r = std::sqrt(u1), phi = 2 * std::numbers::pi * u2;
    const double p1 = r * std::cos(phi), s = 0.5 * (1 + v.z);
    const double p2 = (1 - s) * std::sqrt(std::max(0.0, 1 - p1 * p1)) + s * r * std::sin(phi);
    const glm::dvec3 h = p1 * t1 + p2 * t2 + std::sqrt(std::max(0.0, 1 - p1 * p1 - p2 * p2)) * v;
    return glm::normalize(alpha * h.x * x + alpha * h.y * y + std::max(0.0, h.z) * n);
}

/// The facet that sends `out` to `in`, on the side of the normal; nothing if none can.
std::optional<glm::dvec3>
facet(const RoughSurface& surface, glm::dvec3 out, glm::dvec3 in, bool is_reflection) {
    glm::dvec3 h = is_reflection ? out + in : -(out + surface.index * in);
    const double length = glm::length(h);
    if (!(length > 1e-12))
        return std::nullopt;
    h = h / length;
    if (glm::dot(h, surface.normal) < 0)
        h = -h;
    const double along_out = glm::dot(h, out), along_in = glm::dot(h, in);
    if (along_out <= 0 || (is_reflection ? along_in <= 0 : along_in >= 0))
        return std::nullopt;
    return h;
}

} // namespace

std::optional<Scattered>
sample_rough(const RoughSurface& surface, glm::dvec3 out, double u1, double u2, double u3) {
    const glm::dvec3 h = visible_normal(surface, out, u1, u2);
    const double reflectance = fresnel(glm::dot(out, h), surface.index);
    const bool is_reflection = u3 < reflectance;
    const auto in =
        is_reflection ? std::optional(reflected(-out, h)) : refracted(-out, h, surface.index);
    if (!in)
        return std::nullopt;
    const double along = glm::dot(*in, surface.normal);
    if (is_reflection ? along <= 0 : along >= 0)
        return std::nullopt;
    return Scattered{*in, unshadowed(along, surface.alpha)};
}

double rough_density(const RoughSurface& surface, glm::dvec3 out, glm::dvec3 in) {
    const double along_out = glm::dot(out, surface.normal);
    const double along_in = glm::dot(in, surface.normal);
    if (along_out <= 0 || along_in == 0)
        return 0;
    const bool is_reflection = along_in > 0;
    const auto h = facet(surface, out, in, is_reflection);
    if (!h)
        return 0;
    const double out_h = glm::dot(out, *h), in_h = glm::dot(in, *h);
    const double visible = unshadowed(along_out, surface.alpha) * out_h *
                           ggx(glm::dot(*h, surface.normal), surface.alpha) / along_out;
    const double reflectance = fresnel(out_h, surface.index);
    if (is_reflection)
        return visible * reflectance / (4 * out_h);
    const double sum = out_h + surface.index * in_h;
    return visible * (1 - reflectance) * surface.index * surface.index * -in_h / (sum * sum);
}

double rough_value(const RoughSurface& surface, glm::dvec3 out, glm::dvec3 in) {
    return rough_density(surface, out, in) *
           unshadowed(glm::dot(in, surface.normal), surface.alpha);
}

} // namespace renderer::reference
