// Ambient, diffuse and specular light.  [SHSS, eq. 3 without its fourth term]
#include "renderer/methods/phong.h"

#include "renderer/methods/phong.frag.h"
#include "renderer/methods/phong.vert.h"
#include "renderer/methods/shading.h"

#include <array>
#include <utility>

namespace renderer::methods {

namespace {

class Phong : public Method {
  public:
    explicit Phong(SurfaceShader shader) : shader_(std::move(shader)) {}

    Expected<void> relight(const Scene& scene) override {
        return model_light(scene).map([](const ModelLight&) {});
    }

    void draw(const Scene& scene) override { shader_.draw(scene); }

    Cost cost() const override { return {}; }

  private:
    SurfaceShader shader_;
};

} // namespace

Expected<std::unique_ptr<Method>> prepare_phong(std::shared_ptr<const Surface> surface) {
    const std::array vertex{gpu::ShaderPart{"phong.vert", phong_vert}};
    const std::array fragment{gpu::ShaderPart{"phong.frag", phong_frag}};
    auto shader = SurfaceShader::prepare(std::move(surface), {}, vertex, fragment);
    if (!shader)
        return tl::make_unexpected(shader.error());
    return std::make_unique<Phong>(std::move(*shader));
}

} // namespace renderer::methods
