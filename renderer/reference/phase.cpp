// Henyey-Greenstein and its inversion.
#include "renderer/reference/phase.h"

#include "renderer/contract.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer::reference {

namespace {

struct OnCircle {
    double x, y;
};

/// In float, as rays are traced, which saves a tenth of a walk's time; the length is mended by a
/// step of Newton's, to 1e-14.
OnCircle on_circle(double turn) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(turn);
    const double x = static_cast<double>(std::cos(angle)), y = static_cast<double>(std::sin(angle));
    const double to_unit = 1.5 - 0.5 * (x * x + y * y);
    return {x * to_unit, y * to_unit};
}

} // namespace

double henyey_greenstein(double cosine, double g) {
    EXPECTS(std::abs(g) <= 0.999);
    if (g == 0)
        return 1 / (4 * std::numbers::pi);
    // 1 + g^2 - 2 g cos, without the difference that leaves ten digits at g = 0.999
    const double size = std::abs(g), turned = 1 - std::copysign(1.0, g) * cosine;
    const double square = (1 - size) * (1 - size) + 2 * size * turned;
    return (1 - g * g) / (4 * std::numbers::pi * square * std::sqrt(square));
}

double sample_henyey_greenstein(double u, double g) {
    EXPECTS(std::abs(g) <= 0.999);
    const double s = 2 * u - 1;
    double cosine = 0;
    if (std::abs(g) < 0.5) {
        const double below = 1 + g * s;
        cosine = (2 * s + g * (3 + s * s) + 2 * g * g * s + g * g * g * (s * s - 1)) /
                 (2 * below * below);
    } else {
        const double quotient = (1 - g * g) / (1 + g * s);
        cosine = (1 + g * g - quotient * quotient) / (2 * g);
    }
    return std::clamp(cosine, -1.0, 1.0);
}

glm::dvec3 around(glm::dvec3 axis, double cosine, double turn) {
    // Two perpendiculars without a case distinction that loses digits.  [Duff2017]
    const double sign = std::copysign(1.0, axis.z);
    const double a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
    const glm::dvec3 u(1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
    const glm::dvec3 v(b, sign + axis.y * axis.y * a, -axis.y);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const auto [x, y] = on_circle(turn);
    return cosine * axis + sine * x * u + sine * y * v;
}

glm::dvec3 on_sphere(double u, double turn) {
    const double cosine = 2 * u - 1;
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const auto [x, y] = on_circle(turn);
    return {sine * x, sine * y, cosine};
}

} // namespace renderer::reference
