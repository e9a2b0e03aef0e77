// A ray from every vertex to every light; drawing interpolates what they found.
#include "renderer/methods/traced.h"

#include "renderer/methods/shared_dials.h"
#include "renderer/methods/shss.frag.h"
#include "renderer/methods/shss.vert.h"
#include "renderer/shading/lighting.h"
#include "renderer/shading/shading.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace renderer::methods {

namespace {

constexpr unsigned thickness_location = 2; // behind position and normal

class Traced : public Method {
  public:
    Traced(shading::SurfaceShader shader, thickness::ThicknessTracer tracer, thickness::Kind kind)
        : shader_(std::move(shader)), tracer_(std::move(tracer)), kind_(kind) {}

    Expected<void> update(const Scene& scene, double) override {
        if (const auto ready = shader_.adapt(scene); !ready)
            return ready;
        if (shading::light_setup(scene)->with_points)
            return tl::make_unexpected("traced thickness under a point light, expected directional "
                                       "lights");
        if (lit_ == shading::lighting_of(scene))
            return {};
        lit_.reset();
        if (const auto done = trace(scene); !done)
            return done;
        lit_ = shading::lighting_of(scene);
        return {};
    }

    void draw(const Scene& scene) override { shader_.draw(scene); }

    Cost cost() const override {
        return {.bytes_per_vertex = lights_ * sizeof(float),
                .bytes_per_light = shader_.surface().vertex_count() * sizeof(float),
                .passes_per_light = 1};
    }

  private:
    Expected<void> trace(const Scene& scene) {
        std::vector<glm::dvec3> directions;
        std::vector<double> mm; // to a model unit, along each
        for (const auto& light : scene.lights) {
            const auto seen =
                shading::model_light(std::get<DirectionalLight>(light.place), scene.placement);
            directions.push_back(seen.to_light);
            mm.push_back(1 / seen.stretch);
        }
        const auto lengths = tracer_.trace(kind_, directions);
        if (!lengths)
            return tl::make_unexpected(lengths.error());
        std::vector<float> rows;
        rows.reserve(lengths->size());
        for (std::size_t i = 0; i < lengths->size(); ++i)
            rows.push_back(static_cast<float>((*lengths)[i] * mm[i % mm.size()]));
        lights_ = mm.size();
        thickness_.emplace(std::as_bytes(std::span<const float>(rows)));
        shader_.vertex_array().feed(thickness_location, *thickness_,
                                    {.components = static_cast<int>(lights_), .per_input = 1});
        return {};
    }

    shading::SurfaceShader shader_;
    thickness::ThicknessTracer tracer_;
    thickness::Kind kind_;
    std::optional<gpu::Buffer> thickness_;
    std::size_t lights_ = 1;
    std::optional<shading::Lighting> lit_;
};

} // namespace

Description describe_traced() {
    return {.name = "traced",
            .label = "Traced thickness",
            .source = "",
            .dials = {law_dial(), thickness_dial()},
            .prepare =
                [](const Dials& dials, const Subject& subject) {
                    const TracedSettings settings{thickness_kind(dials), law_of(dials)};
                    return field_with_d_n(settings.law, subject).and_then([&](const auto& field) {
                        return prepare_traced(settings, subject.surface, subject.mesh, field.get());
                    });
                },
            .scatters_by_thickness = true};
}

Expected<std::unique_ptr<Method>> prepare_traced(const TracedSettings& settings,
                                                 std::shared_ptr<const shading::Surface> surface,
                                                 const geometry::Mesh& mesh,
                                                 const thickness::ThicknessField* field) {
    const auto attenuation = shading::attenuation_for(settings.law, field);
    if (!attenuation)
        return tl::make_unexpected(attenuation.error());
    auto tracer = thickness::ThicknessTracer::prepare(mesh);
    if (!tracer)
        return tl::make_unexpected(tracer.error());
    auto shader = shading::SurfaceShader::prepare(
        std::move(surface), *attenuation,
        {.vertex = {{"shss.vert", shss_vert}}, .fragment = {{"shss.frag", shss_frag}}});
    if (!shader)
        return tl::make_unexpected(shader.error());
    return std::make_unique<Traced>(std::move(*shader), std::move(*tracer), settings.kind);
}

} // namespace renderer::methods
