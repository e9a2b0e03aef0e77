// Lights and eye are brought into the model's axes, where the coefficients live.
#include "renderer/methods/band_plan.h"

#include "renderer/contract.h"
#include "renderer/methods/lighting.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace renderer::methods {

namespace {

double brightest(const LinearRgb& colour) {
    return static_cast<double>(std::max({colour.r, colour.g, colour.b}));
}

glm::dvec3 centre_in_world(const Scene& scene, const geometry::BoundingSphere& bounds) {
    return glm::dvec3(scene.placement.world_from_model * glm::dvec4(bounds.centre, 1));
}

/// How much scattered brightness changes with a millimetre of thickness, at most: the laws' slopes
/// where no thickness has been passed yet.
double change_per_mm(const Scene& scene, const Attenuation& attenuation) {
    const auto& k = scene.material.reflectance.scatter;
    if (attenuation.law == Law::Paper) {
        const glm::dmat3 linear(scene.placement.world_from_model);
        return brightest(k) / (attenuation.d_n * std::cbrt(std::abs(glm::determinant(linear))));
    }
    const auto sigma = effective_transport(scene.material.medium);
    return std::max({static_cast<double>(k.r) * sigma.r, static_cast<double>(k.g) * sigma.g,
                     static_cast<double>(k.b) * sigma.b});
}

/// A near light acts from where the centre sees it, with the intensity it has there.
thickness::SeenLight seen_light(const Light& light,
                                const Scene& scene,
                                const geometry::BoundingSphere& bounds,
                                double per_mm) {
    double intensity = brightest(light.intensity);
    DirectionalLight far;
    if (const auto* near = std::get_if<PointLight>(&light.place)) {
        far.to_light = near->position - centre_in_world(scene, bounds);
        const double ratio = near->reference.value / glm::length(far.to_light);
        if (!(glm::length(far.to_light) > 0))
            far.to_light = {0, 0, 1}; // at the centre itself every direction is as good
        else
            intensity *= ratio * ratio;
    } else {
        far = std::get<DirectionalLight>(light.place);
    }
    const auto seen = model_light(far, scene.placement);
    return {seen.to_light, intensity * per_mm / seen.stretch};
}

glm::dvec3 to_eye(const Scene& scene, const geometry::BoundingSphere& bounds) {
    const glm::dvec3 eye(glm::inverse(scene.camera.view_from_world)[3]);
    const auto way = glm::inverse(glm::dmat3(scene.placement.world_from_model)) *
                     (eye - centre_in_world(scene, bounds));
    return glm::length(way) > 0 ? glm::normalize(way) : glm::dvec3(0, 0, 1);
}

} // namespace

BandPlan::BandPlan(const BandSettings& settings,
                   const Attenuation& attenuation,
                   std::shared_ptr<const thickness::ThicknessField> field)
    : settings_(settings), attenuation_(attenuation), field_(std::move(field)) {
    EXPECTS(settings_.bands >= 1 && settings_.bands <= field_->bands);
}

thickness::BandChoice BandPlan::choose(const Scene& scene) const {
    const auto eye = to_eye(scene, field_->bounds);
    const double per_mm = change_per_mm(scene, attenuation_);
    std::vector<thickness::SeenLight> lights;
    for (const auto& light : scene.lights)
        lights.push_back(seen_light(light, scene, field_->bounds, per_mm));
    const int before = choice_ ? choice_->bands : 0;
    if (settings_.chooser == BandChooser::Paper) {
        const auto strongest =
            std::max_element(lights.begin(), lights.end(), [](const auto& a, const auto& b) {
                return a.per_length < b.per_length;
            });
        return thickness::paper_bands(strongest->to_light, eye, settings_.bands, before);
    }
    return thickness::choose_bands(field_->normal_bins, lights, eye, settings_.tolerance, before);
}

BandWeights BandPlan::weights(const Scene& scene, double seconds) {
    int wanted = settings_.bands;
    if (settings_.chooser != BandChooser::Fixed) {
        choice_ = choose(scene);
        wanted = std::min(choice_->bands, settings_.bands);
    }
    if (fade_)
        fade_->advance(wanted, seconds);
    else
        fade_.emplace(settings_.bands, wanted);
    BandWeights weights{};
    std::transform(fade_->weights().begin(), fade_->weights().end(), weights.begin(),
                   [](double weight) { return static_cast<float>(weight); });
    return weights;
}

std::string BandPlan::decision() const {
    return choice_ ? thickness::describe(*choice_, settings_.tolerance) : "";
}

} // namespace renderer::methods
