// One method, three ways to read the light's maps.
#include "renderer/methods/green.h"

#include "renderer/light_maps/blurred.glsl.h"
#include "renderer/light_maps/light_maps.h"
#include "renderer/light_maps/map_blur.h"
#include "renderer/light_maps/nearest.glsl.h"
#include "renderer/light_maps/peeled.glsl.h"
#include "renderer/methods/green.frag.h"
#include "renderer/methods/phong.vert.h"
#include "renderer/methods/shared_dials.h"
#include "renderer/shading/shading.h"

#include <fmt/format.h>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace renderer::methods {

using light_maps::LightMaps;
using light_maps::MapBlur;

namespace {

class Green : public Method {
  public:
    Green(shading::SurfaceShader shader, LightMaps maps)
        : shader_(std::move(shader)), maps_(std::move(maps)) {}

    Expected<void> update(const Scene& scene, double) override {
        if (const auto ready = shader_.adapt(scene); !ready)
            return ready;
        if (lit_ == shading::lighting_of(scene))
            return {};
        lit_.reset();
        if (const auto filled = maps_.fill(scene); !filled)
            return filled;
        lit_ = shading::lighting_of(scene);
        return {};
    }

    void draw(const Scene& scene) override {
        maps_.bind();
        shader_.draw(scene);
    }

    Cost cost() const override {
        return {.bytes_per_light = maps_.bytes_per_light(),
                .passes_per_light = maps_.passes_per_light()};
    }

  private:
    shading::SurfaceShader shader_;
    LightMaps maps_;
    std::optional<shading::Lighting> lit_;
};

// A blur needs no texel finer than this part of its deviation: a map with fewer texels is drawn and
// blurred faster, and says the same.
constexpr double texels_per_deviation = 8;

class GreenBlur : public Method {
  public:
    GreenBlur(shading::SurfaceShader shader,
              LightMaps maps,
              MapBlur blur,
              const GreenSettings& settings)
        : shader_(std::move(shader)), maps_(std::move(maps)), blur_(std::move(blur)),
          largest_map_(settings.depth_map),
          asked_deviation_(std::get<BlurredMap>(settings.map).deviation) {}

    Expected<void> update(const Scene& scene, double) override {
        if (const auto ready = shader_.adapt(scene); !ready)
            return ready;
        if (const auto setup = shading::light_setup(scene); setup->with_points)
            return tl::make_unexpected("a blurred depth map under a point light, expected "
                                       "directional lights, \"green\" or \"green-peel\"");
        const double deviation = deviation_in(scene);
        if (lit_ == shading::lighting_of(scene) && deviation == deviation_)
            return {};
        lit_.reset();
        deviation_ = deviation;
        const double width = diameter_in(scene);
        const auto texels =
            std::min(width * texels_per_deviation / deviation, static_cast<double>(largest_map_));
        const int resolution = std::max(1, static_cast<int>(std::ceil(texels)));
        maps_.set_resolution(resolution);
        if (const auto filled = maps_.fill(scene); !filled)
            return filled;
        for (std::size_t i = 0; i < scene.lights.size(); ++i)
            if (const auto done = blur_.run(maps_.of_light(i), i, deviation * resolution / width);
                !done)
                return done;
        lit_ = shading::lighting_of(scene);
        return {};
    }

    void draw(const Scene& scene) override {
        blur_.bind(scene.lights.size());
        maps_.bind_views();
        shader_.draw(scene);
    }

    Cost cost() const override {
        return {.bytes_per_light = 2 * maps_.bytes_per_light(),
                .passes_per_light = maps_.passes_per_light()};
    }

    std::string decision() const override {
        return lit_ ? fmt::format("blurred by {:.3g} mm", deviation_) : "";
    }

  private:
    double diameter_in(const Scene& scene) const {
        return 2 * shader_.surface().model_sphere().radius *
               shading::largest_stretch(glm::dmat3(scene.placement.world_from_model));
    }

    double deviation_in(const Scene& scene) const {
        if (asked_deviation_)
            return asked_deviation_->value;
        const auto sigma_tr = effective_transport(scene.material.medium);
        const double mean = (sigma_tr.r + sigma_tr.g + sigma_tr.b) / 3;
        return std::min(1 / mean, 0.05 * diameter_in(scene)); // 1/0 is far, too
    }

    shading::SurfaceShader shader_;
    LightMaps maps_;
    MapBlur blur_;
    int largest_map_;
    std::optional<Millimetres> asked_deviation_;
    double deviation_ = 0;
    std::optional<shading::Lighting> lit_;
};

gpu::ShaderPart reading(const GreenSettings& settings) {
    if (std::holds_alternative<BlurredMap>(settings.map))
        return {"blurred.glsl", light_maps::blurred_glsl};
    if (std::holds_alternative<PeeledMap>(settings.map))
        return {"peeled.glsl", light_maps::peeled_glsl};
    return {"nearest.glsl", light_maps::nearest_glsl};
}

int layers_of(const GreenSettings& settings) {
    const auto* peeled = std::get_if<PeeledMap>(&settings.map);
    return peeled == nullptr ? 1 : peeled->layers;
}

GreenSettings settings_from(const Dials& dials) {
    return {.depth_map = static_cast<int>(whole_in(dials, "depth_map")), .law = law_of(dials)};
}

// Several lights keep a map each, and a software renderer keeps them in the machine's memory.
constexpr double most_map_bytes = 4.0 * (1U << 30U);

// As dials, 64 layers of 16384 x 16384 are right one by one, and 69 GB together.
std::optional<DialProblem> refuse_map(const Dials& dials) {
    const auto edge = static_cast<double>(whole_in(dials, "depth_map"));
    const auto layers = static_cast<double>(whole_in(dials, "layers"));
    const double layer_bytes = edge * edge * sizeof(float);
    if (layers * layer_bytes <= most_map_bytes)
        return std::nullopt;
    return DialProblem{
        "layers",
        fmt::format("is {:.0f} of {:.0f} x {:.0f} texels, a map of {:.1f} GiB for every "
                    "light, expected at most {:.0f} GiB: {:.0f} layers, or a smaller "
                    "depth_map",
                    layers, edge, edge, layers * layer_bytes / (1U << 30U),
                    most_map_bytes / (1U << 30U), std::floor(most_map_bytes / layer_bytes))};
}

Expected<std::unique_ptr<Method>> prepare_for(const GreenSettings& settings,
                                              const Subject& subject) {
    return field_with_d_n(settings.law, subject).and_then([&](const auto& field) {
        return prepare_green(settings, subject.surface, field.get());
    });
}

} // namespace

Description describe_green() {
    return {.name = "green",
            .label = "Green 2004",
            .source = "Green2004",
            .dials = {law_dial(), depth_map_dial()},
            .prepare =
                [](const Dials& dials, const Subject& subject) {
                    return prepare_for(settings_from(dials), subject);
                },
            .sweep = one_at_a_time({{"depth_map", {256, 512, 1024, 4096}}}),
            .scatters_by_thickness = true};
}

Description describe_green_blur() {
    return {.name = "green-blur",
            .label = "Green 2004, blurred map",
            .source = "Green2004",
            .dials = {law_dial(),
                      depth_map_dial(),
                      {.name = "blur_mm",
                       .meaning = "standard deviation of the map's blur in mm; auto: 1/sigma_tr of "
                                  "the mean channel, at most 5 % of the diameter",
                       .preset = "auto",
                       .number = DialRange<double>{0.001, 1000},
                       .names = {"auto"}}},
            .prepare =
                [](const Dials& dials, const Subject& subject) {
                    auto settings = settings_from(dials);
                    settings.map = is_name(dials, "blur_mm")
                                       ? BlurredMap{}
                                       : BlurredMap{Millimetres{number_in(dials, "blur_mm")}};
                    return prepare_for(settings, subject);
                },
            .sweep = one_at_a_time({{"depth_map", {64, 128}}, {"blur_mm", {0.5, 1.0, 2.0, 4.0}}}),
            .scatters_by_thickness = true};
}

Description describe_green_peel() {
    return {.name = "green-peel",
            .label = "Green 2004, depth peeling",
            .source = "Green2004",
            .dials = {law_dial(),
                      depth_map_dial(),
                      {.name = "layers",
                       .meaning = "surfaces behind each other that the map keeps, two to a stretch "
                                  "of material",
                       .preset = std::int64_t{PeeledMap{}.layers},
                       .whole = DialRange<std::int64_t>{1, 64}}},
            .prepare =
                [](const Dials& dials, const Subject& subject) {
                    auto settings = settings_from(dials);
                    settings.map = PeeledMap{static_cast<int>(whole_in(dials, "layers"))};
                    return prepare_for(settings, subject);
                },
            .refuse = refuse_map,
            .sweep = one_at_a_time({{"depth_map", {256, 512, 1024}}, {"layers", {2, 4}}}),
            .scatters_by_thickness = true};
}

Expected<std::unique_ptr<Method>> prepare_green(const GreenSettings& settings,
                                                std::shared_ptr<const shading::Surface> surface,
                                                const thickness::ThicknessField* field) {
    const auto attenuation = shading::attenuation_for(settings.law, field);
    if (!attenuation)
        return tl::make_unexpected(attenuation.error());
    auto maps = LightMaps::prepare(surface, settings.depth_map, layers_of(settings));
    if (!maps)
        return tl::make_unexpected(maps.error());
    auto fragment = LightMaps::shader_parts();
    fragment.push_back(reading(settings));
    fragment.push_back({"green.frag", green_frag});
    auto shader = shading::SurfaceShader::prepare(std::move(surface), *attenuation,
                                                  {.defines = maps->defines(),
                                                   .vertex = {{"phong.vert", phong_vert}},
                                                   .fragment = std::move(fragment)});
    if (!shader)
        return tl::make_unexpected(shader.error());
    if (!std::holds_alternative<BlurredMap>(settings.map))
        return std::make_unique<Green>(std::move(*shader), std::move(*maps));
    auto blur = MapBlur::prepare();
    if (!blur)
        return tl::make_unexpected(blur.error());
    return std::make_unique<GreenBlur>(std::move(*shader), std::move(*maps), std::move(*blur),
                                       settings);
}

} // namespace renderer::methods
