// One thickness for all.
#include "renderer/methods/constant.h"

#include "renderer/contract.h"
#include "renderer/methods/constant.frag.h"
#include "renderer/methods/phong.vert.h"
#include "renderer/methods/shared_dials.h"
#include "renderer/shading/shading.h"

#include <glm/vec4.hpp>

#include <utility>

namespace renderer::methods {

namespace {

class Constant : public Method {
  public:
    Constant(shading::SurfaceShader shader, float thickness)
        : shader_(std::move(shader)), block_(sizeof(glm::vec4)) {
        block_.replace_by(glm::vec4(thickness, 0, 0, 0));
    }

    Expected<void> update(const Scene& scene, double) override { return shader_.adapt(scene); }

    void draw(const Scene& scene) override {
        block_.bind_uniform_block(1);
        shader_.draw(scene);
    }

    Cost cost() const override { return {}; }

  private:
    shading::SurfaceShader shader_;
    gpu::Buffer block_;
};

} // namespace

Description describe_constant() {
    return {.name = "constant",
            .label = "Constant translucency",
            .source = "",
            .dials = {law_dial(),
                      {.name = "thickness_mm",
                       .meaning = "the thickness light has come through, everywhere, mm",
                       .preset = 10.0,
                       .number = DialRange<double>{0, 1e6}}},
            .prepare =
                [](const Dials& dials, const Subject& subject) {
                    return field_with_d_n(law_of(dials), subject).and_then([&](const auto& field) {
                        return prepare_constant({number_in(dials, "thickness_mm"), law_of(dials)},
                                                subject.surface, field.get());
                    });
                },
            .sweep = one_at_a_time({{"thickness_mm", {5.0, 20.0}}}),
            .scatters_by_thickness = true};
}

Expected<std::unique_ptr<Method>> prepare_constant(const ConstantSettings& settings,
                                                   std::shared_ptr<const shading::Surface> surface,
                                                   const thickness::ThicknessField* field) {
    EXPECTS(settings.thickness_mm >= 0);
    const auto attenuation = shading::attenuation_for(settings.law, field);
    if (!attenuation)
        return tl::make_unexpected(attenuation.error());
    auto shader = shading::SurfaceShader::prepare(
        std::move(surface), *attenuation,
        {.vertex = {{"phong.vert", phong_vert}}, .fragment = {{"constant.frag", constant_frag}}});
    if (!shader)
        return tl::make_unexpected(shader.error());
    return std::make_unique<Constant>(std::move(*shader),
                                      static_cast<float>(settings.thickness_mm));
}

} // namespace renderer::methods
