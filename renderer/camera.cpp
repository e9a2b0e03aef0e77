// Turntable and camera as products of elementary transforms, right to left.
#include "renderer/camera.h"

#include "renderer/contract.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace renderer {

namespace {

constexpr double field_of_view_degrees = 30;
constexpr double margin = 0.04; // of the sphere's radius

const glm::dvec3 x_axis{1, 0, 0};
const glm::dvec3 y_axis{0, 1, 0};
const glm::dvec3 z_axis{0, 0, 1};

// The smallest rotation that takes `up` to y; half a turn about z where `up` is -y, so that the
// model still faces the camera.
glm::dmat4 upright(glm::dvec3 up) {
    const auto from = glm::normalize(up);
    const auto axis = glm::cross(from, y_axis);
    const double sine = glm::length(axis);
    const double angle = std::atan2(sine, from.y);
    return glm::rotate(glm::dmat4(1), angle, sine > 1e-9 ? axis / sine : z_axis);
}

} // namespace

Placement
place(const geometry::BoundingSphere& model, Millimetres diameter, const Turntable& table) {
    EXPECTS(diameter.value > 0);
    EXPECTS(model.radius > 0);
    EXPECTS(glm::length(table.up) > 0);
    const glm::dmat4 one(1);
    const auto turn = glm::rotate(one, from_degrees(table.turn_degrees).value, y_axis);
    const auto size = glm::scale(one, glm::dvec3(diameter.value / (2 * model.radius)));
    return {turn * upright(table.up) * size * glm::translate(one, -model.centre)};
}

Camera frame(Millimetres diameter, const Turntable& table, double aspect) {
    EXPECTS(diameter.value > 0);
    EXPECTS(aspect > 0);
    EXPECTS(std::abs(table.elevation_degrees) <= 90);
    const double radius = (1 + margin) * diameter.value / 2;
    const double half_angle = from_degrees(field_of_view_degrees).value / 2;
    const double distance = radius / std::sin(half_angle); // the sphere touches the view's edges
    const double near = distance - radius, far = distance + radius;

    const double shorter = near * std::tan(half_angle); // half an edge, on the near plane
    const double right = shorter * std::max(aspect, 1.0);
    const double top = shorter * std::max(1 / aspect, 1.0);
    const glm::dmat4 one(1);
    return {.view_from_world =
                glm::translate(one, {0, 0, -distance}) *
                glm::rotate(one, from_degrees(table.elevation_degrees).value, x_axis),
            .clip_from_view = glm::frustum(-right, right, -top, top, near, far)};
}

glm::dvec3 world_from_view_axes(const Camera& camera, glm::dvec3 direction) {
    return glm::transpose(glm::dmat3(camera.view_from_world)) * direction;
}

} // namespace renderer
