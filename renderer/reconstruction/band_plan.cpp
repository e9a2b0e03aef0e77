// Lights and eye are brought into the model's axes, where the coefficients live.
#include "renderer/reconstruction/band_plan.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"
#include "renderer/shading/lighting.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace renderer::reconstruction {

namespace {

using Channels = std::array<double, 3>;

double brightest(const LinearRgb& colour) {
    return static_cast<double>(std::max({colour.r, colour.g, colour.b}));
}

glm::dvec3 centre_in_world(const Scene& scene, const geometry::BoundingSphere& bounds) {
    return glm::dvec3(scene.placement.world_from_model * glm::dvec4(bounds.centre, 1));
}

/// How much scattered brightness changes with a millimetre of thickness, at most: the laws' slopes
/// where no thickness has been passed yet.
double change_per_mm(const Scene& scene, const shading::Attenuation& attenuation) {
    const auto& k = scene.material.reflectance.scatter;
    if (attenuation.law == shading::Law::Paper) {
        const glm::dmat3 linear(scene.placement.world_from_model);
        return brightest(k) / (attenuation.d_n * std::cbrt(std::abs(glm::determinant(linear))));
    }
    const auto sigma = effective_transport(scene.material.medium);
    return std::max({static_cast<double>(k.r) * sigma.r, static_cast<double>(k.g) * sigma.g,
                     static_cast<double>(k.b) * sigma.b});
}

/// A light as the body's centre sees it: far away, its intensity times `scale`.
struct FarLight {
    DirectionalLight place;
    double scale = 1;
};

FarLight as_far(const Light& light, const Scene& scene, const geometry::BoundingSphere& bounds) {
    const auto* near = std::get_if<PointLight>(&light.place);
    if (near == nullptr)
        return {std::get<DirectionalLight>(light.place), 1};
    const auto way = near->position - centre_in_world(scene, bounds);
    if (!(glm::length(way) > 0))
        return {{{0, 0, 1}}, 1}; // at the centre itself every direction is as good
    const double ratio = near->reference.value / glm::length(way);
    return {{way}, ratio * ratio};
}

thickness::SeenLight seen_light(const Light& light,
                                const Scene& scene,
                                const geometry::BoundingSphere& bounds,
                                double per_mm) {
    const auto far = as_far(light, scene, bounds);
    const auto seen = shading::model_light(far.place, scene.placement);
    return {seen.to_light, brightest(light.intensity) * far.scale * per_mm / seen.stretch};
}

glm::dvec3 to_eye(const Scene& scene, const geometry::BoundingSphere& bounds) {
    const glm::dvec3 eye(glm::inverse(scene.camera.view_from_world)[3]);
    const auto way = glm::inverse(glm::dmat3(scene.placement.world_from_model)) *
                     (eye - centre_in_world(scene, bounds));
    return glm::length(way) > 0 ? glm::normalize(way) : glm::dvec3(0, 0, 1);
}

/// What a light sends to the vertices of a sample: y(L), mm to a model unit along L, and the light
/// that is scattered where it has passed nothing.
struct ReckonedLight {
    std::vector<double> basis;
    double mm = 1;
    Channels scattered{};
};

ReckonedLight reckoned_light(const Light& light,
                             const Scene& scene,
                             const geometry::BoundingSphere& bounds,
                             int bands) {
    const auto far = as_far(light, scene, bounds);
    const auto seen = shading::model_light(far.place, scene.placement);
    const auto& k = scene.material.reflectance.scatter;
    ReckonedLight reckoned;
    reckoned.basis.resize(static_cast<std::size_t>(harmonics::coefficient_count(bands)));
    harmonics::evaluate(bands, seen.to_light, reckoned.basis);
    reckoned.mm = 1 / seen.stretch;
    reckoned.scattered = {far.scale * static_cast<double>(light.intensity.r * k.r),
                          far.scale * static_cast<double>(light.intensity.g * k.g),
                          far.scale * static_cast<double>(light.intensity.b * k.b)};
    return reckoned;
}

/// The law of shading.glsl, lengths in mm.
class WorldLaw {
  public:
    WorldLaw(const Scene& scene, const shading::Attenuation& attenuation, double radius)
        : law_(attenuation.law), sigma_(effective_transport(scene.material.medium)) {
        const glm::dmat3 linear(scene.placement.world_from_model);
        longest_ = 2 * radius * shading::largest_stretch(linear);
        d_n_ = attenuation.d_n * shading::mean_stretch(linear);
    }

    Channels left(double d) const {
        d = std::clamp(d, 0.0, longest_);
        if (law_ == shading::Law::Physical)
            return {std::exp(-sigma_.r * d), std::exp(-sigma_.g * d), std::exp(-sigma_.b * d)};
        const double left = 1 - std::min(d / d_n_, 1.0);
        return {left, left, left};
    }

  private:
    shading::Law law_;
    RgbPerMillimetre sigma_;
    double longest_ = 0, d_n_ = 1;
};

} // namespace

BandPlan::BandPlan(const BandSettings& settings,
                   const shading::Attenuation& attenuation,
                   std::shared_ptr<const thickness::ThicknessField> field,
                   std::optional<thickness::SurfaceSample> sample)
    : settings_(settings), attenuation_(attenuation), field_(std::move(field)),
      sample_(std::move(sample)) {
    EXPECTS(settings_.bands >= 1 && settings_.bands <= field_->bands);
}

/// Root mean square change with 1, 2, ... bands instead of all, in the channel where it is most,
/// over the vertices that face the eye, as large as they look from there.  What they hide from each
/// other is not known here.
std::vector<double> BandPlan::reckoned_changes(const Scene& scene) const {
    const auto bands = static_cast<std::size_t>(settings_.bands);
    std::vector<ReckonedLight> lights;
    for (const auto& light : scene.lights)
        lights.push_back(reckoned_light(light, scene, field_->bounds, sample_->bands));
    const auto eye = glm::dvec3(glm::inverse(scene.placement.world_from_model) *
                                glm::inverse(scene.camera.view_from_world)[3]);
    const WorldLaw law(scene, attenuation_, field_->bounds.radius);
    std::vector<Channels> squares(bands), light_with(bands);
    std::vector<double> d(static_cast<std::size_t>(sample_->bands));
    double shares = 0;
    for (std::size_t i = 0; i < sample_->size(); ++i) {
        const auto way = eye - sample_->positions[i];
        const double share =
            sample_->shares[i] * glm::dot(sample_->normals[i], way) / std::pow(glm::length(way), 3);
        if (!(share > 0))
            continue;
        shares += share;
        std::fill(light_with.begin(), light_with.end(), Channels{});
        for (const auto& light : lights) {
            thickness::thickness_by_bands(*sample_, i, light.basis, d);
            for (std::size_t n = 0; n < bands; ++n) {
                const auto left = law.left(d[n] * light.mm);
                for (std::size_t c = 0; c < 3; ++c)
                    light_with[n][c] += light.scattered[c] * left[c];
            }
        }
        for (std::size_t n = 0; n < bands; ++n)
            for (std::size_t c = 0; c < 3; ++c) {
                const double off = light_with[n][c] - light_with[bands - 1][c];
                squares[n][c] += share * off * off;
            }
    }
    std::vector<double> changes;
    for (const auto& square : squares)
        changes.push_back(
            shares > 0 ? std::sqrt(*std::max_element(square.begin(), square.end()) / shares) : 0);
    return changes;
}

thickness::BandChoice BandPlan::choose(const Scene& scene) const {
    const int previous = choice_ ? choice_->bands : 0;
    if (settings_.chooser == BandChooser::Tolerance && sample_)
        return thickness::choose_bands(reckoned_changes(scene), settings_.tolerance, previous);
    const auto eye = to_eye(scene, field_->bounds);
    const double per_mm = change_per_mm(scene, attenuation_);
    std::vector<thickness::SeenLight> lights;
    for (const auto& light : scene.lights)
        lights.push_back(seen_light(light, scene, field_->bounds, per_mm));
    if (settings_.chooser == BandChooser::Paper) {
        const auto strongest =
            std::max_element(lights.begin(), lights.end(), [](const auto& a, const auto& b) {
                return a.per_length < b.per_length;
            });
        return thickness::paper_bands(strongest->to_light, eye, settings_.bands, previous);
    }
    return thickness::choose_bands(field_->normal_bins, lights, eye, settings_.tolerance, previous);
}

BandWeights BandPlan::weights(const Scene& scene, double seconds) {
    int wanted = settings_.bands;
    choice_ = may_choose_ ? choice_ : std::nullopt;
    if (settings_.chooser != BandChooser::Fixed && may_choose_) {
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

std::optional<double> BandPlan::predicted_change() const {
    if (!choice_ || choice_->predicted.empty())
        return std::nullopt;
    return choice_->predicted.at(static_cast<std::size_t>(choice_->bands) - 1);
}

std::string BandPlan::decision() const {
    return choice_ ? thickness::describe(*choice_, settings_.tolerance) : "";
}

} // namespace renderer::reconstruction
