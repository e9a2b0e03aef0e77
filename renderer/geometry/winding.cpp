// Generalised winding number by plain summation.
#include "renderer/geometry/winding.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace renderer::geometry {

namespace {

/// A sum of angles between -pi and pi, as the argument of a product of complex numbers and the
/// number of its turns: one arctangent in the end, not one for each.
class AngleSum {
  public:
    /// Adds the angle of (x, y), any length but 0.
    void add(double x, double y) {
        const double product_x = x_ * x - y_ * y, product_y = x_ * y + y_ * x;
        if (y >= 0 && y_ >= 0 && product_y < 0)
            ++turns_;
        if (y < 0 && y_ < 0 && product_y >= 0)
            --turns_;
        x_ = product_x;
        y_ = product_y;
        if (const double size = std::abs(x_) + std::abs(y_); size < 1e-100 || size > 1e100) {
            x_ /= size;
            y_ /= size;
        }
    }

    double radians() const {
        return std::atan2(y_, x_) + 2 * std::numbers::pi * static_cast<double>(turns_);
    }

  private:
    double x_ = 1, y_ = 0;
    long turns_ = 0;
};

} // namespace

double winding_number(std::span<const glm::vec3> positions,
                      std::span<const Triangle> triangles,
                      glm::dvec3 point) {
    AngleSum half_solid_angles;
    for (const auto& [i, j, k] : triangles) {
        const glm::dvec3 a = glm::dvec3(positions[i]) - point, b = glm::dvec3(positions[j]) - point,
                         c = glm::dvec3(positions[k]) - point;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        // tan(solid angle / 2), negative denominators included.  [VanOosterom1983, eq. 8]
        const double numerator = glm::dot(a, glm::cross(b, c));
        const double denominator =
            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
        if (numerator != 0 || denominator != 0) // a corner or an edge fills no angle
            half_solid_angles.add(denominator, numerator);
    }
    return half_solid_angles.radians() / (2 * std::numbers::pi);
}

} // namespace renderer::geometry
