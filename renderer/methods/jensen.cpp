// Radiance at the vertices by shadow rays and a hierarchical gather, sent to the GPU as colours.
#include "renderer/methods/jensen.h"

#include "renderer/shading/body_radiance.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace renderer::methods {

namespace {

class JensenDipole : public Method {
  public:
    JensenDipole(shading::SurfaceShader shader, std::unique_ptr<const diffusion::DipoleBody> body)
        : shader_(std::move(shader)), body_(std::move(body)),
          radiance_(shader_.surface().vertex_count() * sizeof(glm::vec3)) {
        shader_.vertex_array().feed(shading::radiance_location, radiance_,
                                    {.components = 3, .per_input = 1});
    }

    Expected<void> update(const Scene& scene, double) override {
        if (const auto ready = shader_.adapt(scene); !ready)
            return ready;
        if (lit_ == shading::lighting_of(scene))
            return {};
        std::vector<glm::vec3> sum(shader_.surface().vertex_count());
        for (const auto& [to_light, irradiance] :
             shading::incident_lights(scene, shader_.surface())) {
            const auto share = body_->exit_radiance(to_light);
            for (std::size_t v = 0; v < sum.size(); ++v)
                sum[v] += glm::vec3(irradiance) * share[v];
        }
        radiance_.replace(std::as_bytes(std::span<const glm::vec3>(sum)));
        lit_ = shading::lighting_of(scene);
        return {};
    }

    void draw(const Scene& scene) override { shader_.draw(scene); }

    Cost cost() const override {
        return {.bytes_per_vertex = sizeof(glm::vec3), .bytes_per_light = radiance_.bytes()};
    }

    std::string decision() const override {
        const auto& samples = body_->samples();
        return fmt::format("{} surface samples{}", samples.positions.size(),
                           samples.undersampled ? ", undersampled: farther apart than one "
                                                  "transport mean free path"
                                                : "");
    }

  private:
    shading::SurfaceShader shader_;
    std::unique_ptr<const diffusion::DipoleBody> body_;
    gpu::Buffer radiance_;
    std::optional<shading::Lighting> lit_;
};

Expected<std::unique_ptr<Method>> prepare_from_dials(const Dials&, const Subject& subject) {
    const auto& s = subject.material.medium.sigma_s_reduced;
    if (!(s.r > 0 || s.g > 0 || s.b > 0))
        return tl::make_unexpected("the medium scatters in no channel, expected a sigma_s' above 0 "
                                   "in one of them");
    return prepare_jensen(subject.surface, std::make_unique<diffusion::DipoleBody>(
                                               subject.mesh, subject.material.medium,
                                               shading::mm_per_unit(subject.placement)));
}

} // namespace

Description describe_jensen() {
    return {.name = "jensen",
            .label = "Jensen 2001 dipole",
            .source = "Jensen2001",
            .dials = {},
            .prepare = prepare_from_dials};
}

Expected<std::unique_ptr<Method>>
prepare_jensen(std::shared_ptr<const shading::Surface> surface,
               std::unique_ptr<const diffusion::DipoleBody> body) {
    auto shader = shading::body_radiance_shader(std::move(surface));
    if (!shader)
        return tl::make_unexpected(shader.error());
    return std::make_unique<JensenDipole>(std::move(*shader), std::move(body));
}

} // namespace renderer::methods
