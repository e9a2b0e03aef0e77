// A light's depth map blurred: a Gaussian, one axis after the other, over the texels that see
// something.  Empty ones would drag the depths at the rim toward 0.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/buffer.h"
#include "renderer/gpu/screen_pass.h"
#include "renderer/gpu/target.h"

#include <optional>
#include <vector>

namespace renderer::light_maps {

class MapBlur {
  public:
    /// Errors: the driver's log.
    static Expected<MapBlur> prepare();

    /// Blurs the first layer of a light's map.  `deviation` is in texels; the Gaussian is cut off
    /// at three of them.  Texels that saw nothing get the mean of what they have in reach. Errors:
    /// what the device cannot hold.  EXPECTS deviation >= 0.
    Expected<void> run(const gpu::LayeredMap& map, std::size_t light, double deviation);

    /// Makes the blurred maps of the first `lights` lights the textures from unit 0 on; they are
    /// read smoothly.
    void bind(std::size_t lights) const;

  private:
    MapBlur(gpu::ScreenPass rows, gpu::ScreenPass columns);

    Expected<void> make_room(int resolution, std::size_t light);

    gpu::ScreenPass rows_;
    gpu::ScreenPass columns_;
    gpu::Buffer block_;
    std::optional<gpu::Target> between_;
    std::vector<gpu::LayeredMap> blurred_;
};

} // namespace renderer::light_maps
