// Two passes over the map: rows, then columns.
#include "renderer/light_maps/map_blur.h"

#include "renderer/contract.h"
#include "renderer/light_maps/map_blur.frag.h"

#include <array>
#include <cmath>
#include <utility>

namespace renderer::light_maps {

namespace {

struct GaussianBlock { // block Gaussian of map_blur.frag, std140
    float deviation;
    int radius;
    std::array<float, 2> padding{};
};

Expected<gpu::ScreenPass> link(std::string_view defines) {
    const std::array parts{gpu::ShaderPart{"defines", defines},
                           gpu::ShaderPart{"map_blur.frag", map_blur_frag}};
    return gpu::ScreenPass::link(parts);
}

} // namespace

MapBlur::MapBlur(gpu::ScreenPass rows, gpu::ScreenPass columns)
    : rows_(std::move(rows)), columns_(std::move(columns)), block_(sizeof(GaussianBlock)) {}

Expected<MapBlur> MapBlur::prepare() {
    auto rows = link("#define ROWS");
    if (!rows)
        return tl::make_unexpected(rows.error());
    auto columns = link("");
    if (!columns)
        return tl::make_unexpected(columns.error());
    return MapBlur(std::move(*rows), std::move(*columns));
}

Expected<void> MapBlur::make_room(int resolution, std::size_t light) {
    EXPECTS(light <= blurred_.size());
    if (!between_ || between_->width() != resolution) {
        auto target = gpu::Target::create(resolution, resolution);
        if (!target)
            return tl::make_unexpected(target.error());
        between_ = std::move(*target);
    }
    if (light < blurred_.size() && blurred_[light].resolution() == resolution)
        return {};
    auto map = gpu::LayeredMap::create(resolution, 1, gpu::LayeredMap::Reading::Linear);
    if (!map)
        return tl::make_unexpected(map.error());
    if (light < blurred_.size())
        blurred_[light] = std::move(*map);
    else
        blurred_.push_back(std::move(*map));
    return {};
}

Expected<void> MapBlur::run(const gpu::LayeredMap& map, std::size_t light, double deviation) {
    EXPECTS(deviation >= 0);
    if (const auto room = make_room(map.resolution(), light); !room)
        return room;
    block_.replace_by(
        GaussianBlock{static_cast<float>(deviation), static_cast<int>(std::ceil(3 * deviation))});
    block_.bind_uniform_block(0);
    map.bind_texture(0);
    {
        const auto drawing = between_->draw_into();
        rows_.run();
    }
    between_->bind_texture(0);
    const auto drawing = blurred_[light].draw_into(0);
    columns_.run();
    return {};
}

void MapBlur::bind(std::size_t lights) const {
    EXPECTS(lights <= blurred_.size());
    for (unsigned i = 0; i < lights; ++i)
        blurred_[i].bind_texture(i);
}

} // namespace renderer::light_maps
