// Three passes over the picture: the body's light, its rows blurred, its columns blurred where the
// surface is drawn, so that depth, coverage and alpha are those of every other method.
#include "renderer/methods/separable.h"

#include "renderer/diffusion/diffusion_profile.h"
#include "renderer/gpu/screen_pass.h"
#include "renderer/gpu/target.h"
#include "renderer/light_maps/light_maps.h"
#include "renderer/light_maps/nearest.glsl.h"
#include "renderer/methods/phong.vert.h"
#include "renderer/methods/separable.frag.h"
#include "renderer/methods/separable_blur.glsl.h"
#include "renderer/methods/separable_body.frag.h"
#include "renderer/methods/separable_rows.frag.h"
#include "renderer/methods/shared_dials.h"
#include "renderer/shading/shading.h"

#include <fmt/format.h>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace renderer::methods {

using light_maps::LightMaps;

namespace {

constexpr unsigned picture_unit = 8; // behind the light maps
constexpr int most_taps = 101;

struct DiffusionBlock { // block Diffusion of separable_blur.glsl, std140; taps follow it
    glm::vec4 depth_axis;
    glm::vec4 scale;
    glm::vec4 tail;
    std::array<int, 4> corner;
};

DiffusionBlock
diffusion_block(const Camera& camera, const gpu::Viewport& viewport, const glm::dvec3& d) {
    const auto &V = camera.view_from_world, &P = camera.clip_from_view;
    return {.depth_axis = glm::vec4(-V[0][2], -V[1][2], -V[2][2], -V[3][2]),
            .scale = glm::vec4(P[0][0] * viewport.width / 2, P[1][1] * viewport.height / 2,
                               -P[2][3], P[3][3]),
            .tail = glm::vec4(3.0 * d, 0),
            .corner = {viewport.left, viewport.bottom, 0, 0}};
}

class Separable : public Method {
  public:
    Separable(shading::SurfaceShader body,
              gpu::ScreenPass rows,
              shading::SurfaceShader last,
              LightMaps maps,
              int taps)
        : body_(std::move(body)), rows_(std::move(rows)), last_(std::move(last)),
          maps_(std::move(maps)), taps_(taps),
          block_(sizeof(DiffusionBlock) + static_cast<std::size_t>(taps) * sizeof(glm::vec4)) {}

    Expected<void> update(const Scene& scene, double) override {
        if (const auto ready = body_.adapt(scene); !ready)
            return ready;
        if (const auto ready = last_.adapt(scene); !ready)
            return ready;
        take_up(scene.material.medium);
        if (lit_ == shading::lighting_of(scene))
            return {};
        lit_.reset();
        if (const auto filled = maps_.fill(scene); !filled)
            return filled;
        lit_ = shading::lighting_of(scene);
        return {};
    }

    void draw(const Scene& scene) override {
        const auto viewport = gpu::bound_viewport();
        make_room(viewport);
        send(diffusion_block(scene.camera, viewport, length_));
        block_.bind_uniform_block(2);
        {
            const auto drawing = unblurred_->draw_into();
            unblurred_->clear();
            maps_.bind();
            body_.draw(scene);
        }
        {
            const auto drawing = half_blurred_->draw_into();
            unblurred_->bind_texture(picture_unit);
            rows_.run();
        }
        half_blurred_->bind_texture(picture_unit);
        last_.draw(scene);
    }

    Cost cost() const override {
        return {.bytes_per_light = maps_.bytes_per_light(),
                .passes_per_light = maps_.passes_per_light(),
                .passes_per_picture = 2};
    }

  private:
    void take_up(const Medium& medium) {
        const auto length = diffusion::diffusion_length(medium);
        if (length == length_ && !kernel_.empty())
            return;
        length_ = length;
        kernel_.clear();
        for (const auto& tap : diffusion::diffusion_taps(length, taps_))
            kernel_.emplace_back(glm::vec3(tap.weight), static_cast<float>(tap.offset));
    }

    void make_room(const gpu::Viewport& viewport) {
        for (auto* target : {&unblurred_, &half_blurred_}) {
            if (*target && (*target)->width() == viewport.width &&
                (*target)->height() == viewport.height)
                continue;
            target->reset(); // the old one makes room for the new
            auto made = gpu::Target::create(viewport.width, viewport.height);
            if (!made)
                throw std::runtime_error("separable: " + made.error());
            *target = std::move(*made);
        }
    }

    void send(const DiffusionBlock& head) {
        std::vector<std::byte> bytes(block_.bytes());
        const auto first = std::as_bytes(std::span(&head, 1));
        const auto rest = std::as_bytes(std::span(kernel_));
        std::copy(rest.begin(), rest.end(), std::copy(first.begin(), first.end(), bytes.begin()));
        block_.replace(bytes);
    }

    shading::SurfaceShader body_;
    gpu::ScreenPass rows_;
    shading::SurfaceShader last_;
    LightMaps maps_;
    int taps_;
    gpu::Buffer block_;
    glm::dvec3 length_{}; // of the profile, mm
    std::vector<glm::vec4> kernel_;
    std::optional<gpu::Target> unblurred_, half_blurred_;
    std::optional<shading::Lighting> lit_;
};

std::optional<DialProblem> refuse_dials(const Dials& dials) {
    const auto taps = whole_in(dials, "taps");
    if (taps % 2 == 1)
        return std::nullopt;
    return DialProblem{"taps",
                       fmt::format("is {}, expected an odd number: one in the middle", taps)};
}

Expected<std::unique_ptr<Method>> prepare_from_dials(const Dials& dials, const Subject& subject) {
    const SeparableSettings settings{.taps = static_cast<int>(whole_in(dials, "taps")),
                                     .depth_map = static_cast<int>(whole_in(dials, "depth_map")),
                                     .law = law_of(dials)};
    return field_with_d_n(settings.law, subject).and_then([&](const auto& field) {
        return prepare_separable(settings, subject.surface, field.get());
    });
}

} // namespace

Description describe_separable() {
    return {.name = "separable",
            .label = "Separable screen-space",
            .source = "Jimenez2015",
            .dials = {law_dial(),
                      depth_map_dial(),
                      {.name = "taps",
                       .meaning = "samples of the blur along a row and along a column, odd",
                       .preset = std::int64_t{SeparableSettings{}.taps},
                       .whole = DialRange<std::int64_t>{3, most_taps}}},
            .prepare = prepare_from_dials,
            .refuse = refuse_dials,
            .sweep = one_at_a_time({{"depth_map", {256, 512, 1024}}, {"taps", {9, 17, 51}}})};
}

Expected<std::unique_ptr<Method>> prepare_separable(const SeparableSettings& settings,
                                                    std::shared_ptr<const shading::Surface> surface,
                                                    const thickness::ThicknessField* field) {
    const auto attenuation = shading::attenuation_for(settings.law, field);
    if (!attenuation)
        return tl::make_unexpected(attenuation.error());
    auto maps = LightMaps::prepare(surface, settings.depth_map, 1);
    if (!maps)
        return tl::make_unexpected(maps.error());
    const auto defines = maps->defines() + fmt::format("#define TAPS {}\n", settings.taps);
    const gpu::ShaderPart blur{"separable_blur.glsl", separable_blur_glsl},
        vertex{"phong.vert", phong_vert};

    auto parts = LightMaps::shader_parts();
    parts.push_back({"nearest.glsl", light_maps::nearest_glsl});
    parts.push_back(blur);
    parts.push_back({"separable_body.frag", separable_body_frag});
    auto body = shading::SurfaceShader::prepare(
        surface, *attenuation, {.defines = defines, .vertex = {vertex}, .fragment = parts});
    if (!body)
        return tl::make_unexpected(body.error());
    auto last =
        shading::SurfaceShader::prepare(std::move(surface), *attenuation,
                                        {.defines = defines,
                                         .vertex = {vertex},
                                         .fragment = {blur, {"separable.frag", separable_frag}}});
    if (!last)
        return tl::make_unexpected(last.error());
    const std::array row_parts{gpu::ShaderPart{"defines", defines}, blur,
                               gpu::ShaderPart{"separable_rows.frag", separable_rows_frag}};
    auto rows = gpu::ScreenPass::link(row_parts);
    if (!rows)
        return tl::make_unexpected(rows.error());
    return std::make_unique<Separable>(std::move(*body), std::move(*rows), std::move(*last),
                                       std::move(*maps), settings.taps);
}

} // namespace renderer::methods
