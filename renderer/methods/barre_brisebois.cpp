// One more float a vertex, and ten operations a light.
#include "renderer/methods/barre_brisebois.h"

#include "renderer/gpu/buffer.h"
#include "renderer/methods/barre_brisebois.frag.h"
#include "renderer/methods/barre_brisebois.vert.h"
#include "renderer/methods/shared_dials.h"
#include "renderer/shading/lighting.h"
#include "renderer/shading/shading.h"
#include "renderer/thickness/local_thickness.h"

#include <glm/mat3x3.hpp>

#include <array>
#include <utility>

namespace renderer::methods {

namespace {

constexpr unsigned thickness_location = 2; // behind position and normal

class BarreBrisebois : public Method {
  public:
    BarreBrisebois(shading::SurfaceShader shader,
                   gpu::Buffer thickness,
                   const std::array<float, 4>& lobe)
        : shader_(std::move(shader)), thickness_(std::move(thickness)),
          lobe_(gpu::Buffer::holding<float>(lobe)) {
        shader_.vertex_array().feed(thickness_location, thickness_, {.components = 1});
    }

    Expected<void> update(const Scene& scene, double) override { return shader_.adapt(scene); }

    void draw(const Scene& scene) override {
        lobe_.bind_uniform_block(1);
        shader_.draw(scene);
    }

    Cost cost() const override { return {.bytes_per_vertex = sizeof(float)}; }

  private:
    shading::SurfaceShader shader_;
    gpu::Buffer thickness_;
    gpu::Buffer lobe_;
};

Dial number_dial(std::string name, std::string meaning, double preset, DialRange<double> range) {
    return {
        .name = std::move(name), .meaning = std::move(meaning), .preset = preset, .number = range};
}

std::vector<Dial> dials() {
    const BarreBriseboisSettings preset;
    return {
        law_dial(),
        {.name = "thickness",
         .meaning = "which lengths the local thickness is the mean of: all interior segments, "
                    "or the one that starts at the vertex",
         .preset = "sum",
         .names = {"sum", "first"}},
        number_dial("distortion", "how far the normal bends the light that comes through",
                    preset.distortion, {0, 1}),
        number_dial("power", "how narrow the lobe around the light's way on is", preset.power,
                    {1, 64}),
        number_dial("scale", "the lobe's height", preset.scale, {0, 16}),
        number_dial("ambient", "what comes through toward every side", preset.ambient, {0, 16})};
}

Expected<std::unique_ptr<Method>> prepare_from_dials(const Dials& given, const Subject& subject) {
    const BarreBriseboisSettings settings{.distortion = number_in(given, "distortion"),
                                          .power = number_in(given, "power"),
                                          .scale = number_in(given, "scale"),
                                          .ambient = number_in(given, "ambient"),
                                          .law = law_of(given)};
    const auto kind =
        name_in(given, "thickness") == "first" ? thickness::Kind::First : thickness::Kind::Sum;
    const auto field = subject.field({.kind = kind}); // SHSS's own, when it is at its presets
    if (!field)
        return tl::make_unexpected(field.error());
    return prepare_barre_brisebois(
        settings, subject.surface, subject.mesh, **field,
        shading::mean_stretch(glm::dmat3(subject.placement.world_from_model)));
}

} // namespace

Description describe_barre_brisebois() {
    return {.name = "barre-brisebois",
            .label = "Barr\u00e9-Brisebois 2011",
            .source = "BarreBrisebois2011",
            .dials = dials(),
            .prepare = prepare_from_dials,
            .sweep = one_at_a_time({{"thickness", {"first"}}})};
}

Expected<std::unique_ptr<Method>>
prepare_barre_brisebois(const BarreBriseboisSettings& settings,
                        std::shared_ptr<const shading::Surface> surface,
                        const geometry::Mesh& mesh,
                        const thickness::ThicknessField& field,
                        double mm_per_unit) {
    const auto attenuation = shading::attenuation_for(settings.law, &field);
    if (!attenuation)
        return tl::make_unexpected(attenuation.error());
    const auto baked = thickness::local_thickness(mesh, field);
    if (!baked)
        return tl::make_unexpected(baked.error());
    std::vector<float> thickness;
    thickness.reserve(baked->size());
    for (const double d : *baked)
        thickness.push_back(static_cast<float>(d * mm_per_unit));
    auto shader = shading::SurfaceShader::prepare(
        std::move(surface), *attenuation,
        {.defines = {},
         .vertex = {{"barre_brisebois.vert", barre_brisebois_vert}},
         .fragment = {{"barre_brisebois.frag", barre_brisebois_frag}}});
    if (!shader)
        return tl::make_unexpected(shader.error());
    const std::array lobe{static_cast<float>(settings.distortion),
                          static_cast<float>(settings.power), static_cast<float>(settings.scale),
                          static_cast<float>(settings.ambient)};
    return std::make_unique<BarreBrisebois>(std::move(*shader),
                                            gpu::Buffer::holding<float>(thickness), lobe);
}

} // namespace renderer::methods
