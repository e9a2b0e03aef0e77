// How much material lies along a ray through the bodies of bodies.h, in closed form.
#include "renderer/geometry/body_thickness.h"

#include "renderer/contract.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace renderer::geometry {

namespace {

struct Stretch {
    double begin = 0, end = 0;
};

constexpr double starts_at_the_point = 1e-9; // of the body's size

/// Lengths from the stretches of the whole line inside the material, in ascending order.
BodyThickness lengths(std::span<const Stretch> inside, double size) {
    BodyThickness result;
    for (const auto& [begin_on_line, end] : inside) {
        const double begin = std::max(begin_on_line, 0.0);
        if (!(end > begin))
            continue;
        if (begin <= starts_at_the_point * size && result.sum <= starts_at_the_point * size)
            result.first = end - begin;
        result.sum += end - begin;
        result.span = end;
    }
    return result;
}

void expect_unit(glm::dvec3 s) {
    EXPECTS(std::abs(glm::length(s) - 1) <= 1e-6);
}

/// The line's stretch inside the ellipsoid, whose image under p / semi_axes is the unit sphere.
std::optional<Stretch> inside_ellipsoid(glm::dvec3 semi_axes, glm::dvec3 p, glm::dvec3 s) {
    const auto q = p / semi_axes, d = s / semi_axes;
    const double a = glm::dot(d, d), b = glm::dot(q, d), c = glm::dot(q, q) - 1;
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0))
        return std::nullopt;
    // The root without cancellation first; the other from the product of the two.
    const double far = -(b + std::copysign(std::sqrt(discriminant), b));
    const double one = far / a, other = c / far;
    return Stretch{std::min(one, other), std::max(one, other)};
}

double evaluate(std::span<const double> polynomial, double t) {
    double value = 0;
    for (auto coefficient = polynomial.rbegin(); coefficient != polynomial.rend(); ++coefficient)
        value = value * t + *coefficient;
    return value;
}

double bisect(std::span<const double> polynomial, double low, double high) {
    const bool low_is_negative = evaluate(polynomial, low) < 0;
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (!(low < middle && middle < high))
            return middle;
        ((evaluate(polynomial, middle) < 0) == low_is_negative ? low : high) = middle;
    }
}

/// Where the polynomial changes sign in [low, high], ascending: between two neighbouring extrema it
/// is monotone, and the extrema are the sign changes of its derivative.
std::vector<double> sign_changes(std::span<const double> polynomial, double low, double high) {
    if (polynomial.size() < 2)
        return {};
    std::vector<double> derivative;
    for (std::size_t k = 1; k < polynomial.size(); ++k)
        derivative.push_back(static_cast<double>(k) * polynomial[k]);
    auto knots = sign_changes(derivative, low, high);
    knots.insert(knots.begin(), low);
    knots.push_back(high);
    std::vector<double> roots;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k)
        if ((evaluate(polynomial, knots[k]) < 0) != (evaluate(polynomial, knots[k + 1]) < 0))
            roots.push_back(bisect(polynomial, knots[k], knots[k + 1]));
    return roots;
}

} // namespace

BodyThickness ellipsoid_thickness(glm::dvec3 semi_axes, glm::dvec3 p, glm::dvec3 s) {
    expect_unit(s);
    const auto inside = inside_ellipsoid(semi_axes, p, s);
    if (!inside)
        return {};
    return lengths({&*inside, 1}, std::max({semi_axes.x, semi_axes.y, semi_axes.z}));
}

BodyThickness sphere_thickness(double radius, glm::dvec3 p, glm::dvec3 s) {
    return ellipsoid_thickness(glm::dvec3(radius), p, s);
}

BodyThickness
shell_thickness(double outer_radius, double inner_radius, glm::dvec3 p, glm::dvec3 s) {
    EXPECTS(0 < inner_radius && inner_radius < outer_radius);
    expect_unit(s);
    const auto outer = inside_ellipsoid(glm::dvec3(outer_radius), p, s);
    if (!outer)
        return {};
    const auto cavity = inside_ellipsoid(glm::dvec3(inner_radius), p, s);
    if (!cavity)
        return lengths({&*outer, 1}, outer_radius);
    const Stretch stretches[] = {{outer->begin, cavity->begin}, {cavity->end, outer->end}};
    return lengths(stretches, outer_radius);
}

BodyThickness
torus_thickness(double major_radius, double minor_radius, glm::dvec3 p, glm::dvec3 s) {
    EXPECTS(0 < minor_radius && minor_radius < major_radius);
    expect_unit(s);
    // Measured from the line's nearest point to the centre, t = u - nearest, the polynomial
    //   (u^2 + k)^2 - 4 R^2 |q_xy + u s_xy|^2,  k = |q|^2 + R^2 - r^2,
    // has no odd terms but one, and is negative inside the tube.
    const double nearest = glm::dot(p, s);
    const auto q = p - nearest * s;
    const double bound = major_radius + minor_radius;
    if (!(glm::dot(q, q) < bound * bound))
        return {};
    const double k = glm::dot(q, q) + (major_radius - minor_radius) * (major_radius + minor_radius);
    const double four_rr = 4 * major_radius * major_radius;
    const double quartic[] = {k * k - four_rr * (q.x * q.x + q.y * q.y),
                              -2 * four_rr * (q.x * s.x + q.y * s.y),
                              2 * k - four_rr * (s.x * s.x + s.y * s.y), 0, 1};
    // 2 * bound lies outside the tube, so the changes come in pairs: in, out.
    const auto changes = sign_changes(quartic, -2 * bound, 2 * bound);
    std::vector<Stretch> inside;
    for (std::size_t i = 0; i + 1 < changes.size(); i += 2)
        inside.push_back({changes[i] - nearest, changes[i + 1] - nearest});
    return lengths(inside, bound);
}

BodyThickness
slab_thickness(double width, double height, double thickness, glm::dvec3 p, glm::dvec3 s) {
    expect_unit(s);
    const auto half = 0.5 * glm::dvec3(width, height, thickness);
    Stretch inside{-std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        if (s[axis] == 0) {
            if (std::abs(p[axis]) >= half[axis]) // along a face counts as outside
                return {};
            continue;
        }
        const double one = (-half[axis] - p[axis]) / s[axis];
        const double other = (half[axis] - p[axis]) / s[axis];
        inside.begin = std::max(inside.begin, std::min(one, other));
        inside.end = std::min(inside.end, std::max(one, other));
    }
    return lengths({&inside, 1}, std::max({width, height, thickness}));
}

} // namespace renderer::geometry
