// Ambient, diffuse and specular light.  [SHSS, eq. 3 without its fourth term]
#include "renderer/methods/phong.h"

#include "renderer/methods/phong.frag.h"
#include "renderer/methods/phong.vert.h"
#include "renderer/shading/shading.h"

#include <utility>

namespace renderer::methods {

namespace {

class Phong : public Method {
  public:
    explicit Phong(shading::SurfaceShader shader) : shader_(std::move(shader)) {}

    Expected<void> update(const Scene& scene, double) override { return shader_.adapt(scene); }

    void draw(const Scene& scene) override { shader_.draw(scene); }

    Cost cost() const override { return {}; }

  private:
    shading::SurfaceShader shader_;
};

} // namespace

Description describe_phong() {
    return {.name = "phong",
            .label = "Phong",
            .source = "",
            .dials = {},
            .prepare = [](const Dials&, const Subject& subject) {
                return prepare_phong(subject.surface);
            }};
}

Expected<std::unique_ptr<Method>> prepare_phong(std::shared_ptr<const shading::Surface> surface) {
    auto shader = shading::SurfaceShader::prepare(
        std::move(surface), {},
        {.vertex = {{"phong.vert", phong_vert}}, .fragment = {{"phong.frag", phong_frag}}});
    if (!shader)
        return tl::make_unexpected(shader.error());
    return std::make_unique<Phong>(std::move(*shader));
}

} // namespace renderer::methods
