// Lights are checked here, once, for every method.
#include "renderer/shading/lighting.h"

#include "renderer/contract.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace renderer::shading {

namespace {

bool is_finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Expected<void> check(const DirectionalLight& light) {
    const auto& L = light.to_light;
    if (const double length = glm::length(L); !(length > 0) || !std::isfinite(length))
        return tl::make_unexpected(fmt::format(
            "light direction ({}, {}, {}), expected a vector with a length", L.x, L.y, L.z));
    return {};
}

Expected<void> check(const PointLight& light) {
    const auto& p = light.position;
    if (!is_finite(p))
        return tl::make_unexpected(
            fmt::format("light position ({}, {}, {}), expected finite numbers", p.x, p.y, p.z));
    if (!(light.reference.value > 0))
        return tl::make_unexpected(fmt::format(
            "a light's reference distance is {} mm, expected > 0", light.reference.value));
    return {};
}

} // namespace

Expected<LightSetup> light_setup(const Scene& scene) {
    if (scene.lights.empty() || scene.lights.size() > most_lights)
        return tl::make_unexpected(
            fmt::format("{} lights, expected 1 to {}", scene.lights.size(), most_lights));
    const double volume = glm::determinant(glm::dmat3(scene.placement.world_from_model));
    if (volume == 0 || !std::isfinite(volume))
        return tl::make_unexpected("the placement flattens the model, expected one that can be "
                                   "undone");
    LightSetup setup{.count = static_cast<int>(scene.lights.size())};
    for (const auto& light : scene.lights) {
        const auto good = std::visit([](const auto& place) { return check(place); }, light.place);
        if (!good)
            return tl::make_unexpected(good.error());
        setup.with_points = setup.with_points || std::holds_alternative<PointLight>(light.place);
    }
    return setup;
}

std::string defines(const LightSetup& setup) {
    return fmt::format("#define LIGHTS {}\n{}", setup.count,
                       setup.with_points ? "#define POINT_LIGHTS\n" : "");
}

Lighting lighting_of(const Scene& scene) {
    return {scene.lights, scene.placement};
}

ModelLight model_light(const DirectionalLight& light, const Placement& placement) {
    const auto v = glm::inverse(glm::dmat3(placement.world_from_model)) *
                   (light.to_light / glm::length(light.to_light));
    EXPECTS(glm::length(v) > 0);
    return {glm::normalize(v), glm::length(v)};
}

double largest_stretch(const glm::dmat3& A) {
    const auto squared = glm::transpose(A) * A;
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        largest = std::max(largest, std::abs(squared[i].x) + std::abs(squared[i].y) +
                                        std::abs(squared[i].z));
    return std::sqrt(largest);
}

double mean_stretch(const glm::dmat3& A) {
    return std::cbrt(std::abs(glm::determinant(A)));
}

} // namespace renderer::shading
