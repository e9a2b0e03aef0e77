// Filling the block of show.frag.
#include "experiment/viewer/picture_pass.h"

#include "experiment/viewer/false_colours.h"
#include "experiment/viewer/show.frag.h"
#include "renderer/imaging/colour.h"

#include <glm/vec4.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace experiment::viewer {

namespace gpu = renderer::gpu;

namespace {

struct ShowBlock { // block Show of show.frag, std140
    glm::vec4 place{};
    glm::vec4 scale{};
    std::array<glm::vec4, 256> colours{};
};

const std::array<glm::vec4, 256>& palette() {
    static const auto colours = [] {
        std::array<glm::vec4, 256> all{};
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto colour = false_colour(static_cast<double>(i) / 255);
            all[i] = {colour.r, colour.g, colour.b, 1};
        }
        return all;
    }();
    return colours;
}

float look_number(Look look) {
    return look == Look::Light ? 0.0F : look == Look::Thickness ? 1.0F : 2.0F;
}

} // namespace

PicturePass::PicturePass(gpu::ScreenPass pass) : pass_(std::move(pass)), block_(sizeof(ShowBlock)) {}

tl::expected<PicturePass, std::string> PicturePass::create() {
    const std::array fragment{gpu::ShaderPart{"show.frag", show_frag}};
    auto pass = gpu::ScreenPass::link(fragment);
    if (!pass)
        return tl::make_unexpected(pass.error());
    return PicturePass(std::move(*pass));
}

void PicturePass::draw(const gpu::Target& left,
                       const gpu::Target& right,
                       const Composition& composition) {
    const auto& place = composition.place;
    const double surround = renderer::imaging::linear_from_srgb(composition.surround / 255.0);
    block_.replace_by(ShowBlock{
        .place = {static_cast<float>(place.left), static_cast<float>(place.bottom),
                  static_cast<float>(std::round(composition.right_from * place.width)),
                  composition.line ? 1.0F : 0.0F},
        .scale = {look_number(composition.look), static_cast<float>(composition.whole),
                  static_cast<float>(composition.reach.value), static_cast<float>(surround)},
        .colours = palette()});
    block_.bind_uniform_block(0);
    left.bind_texture(0);
    right.bind_texture(1);
    pass_.run(place);
}

} // namespace experiment::viewer
