// A picture of many channels: what a render under way has to remember beside its light.
#pragma once

#include <string>
#include <vector>

namespace renderer::imaging {

struct Layer {
    std::string channel; ///< "R", "variance.G", ...
    std::vector<float> values;
};

/// Row-major, top row first, every layer of width x height values.
struct LayeredImage {
    int width = 0, height = 0;
    std::vector<Layer> layers;
};

/// The layer of that name; null when there is none.
inline const Layer* find_layer(const LayeredImage& image, const std::string& channel) {
    for (const auto& layer : image.layers)
        if (layer.channel == channel)
            return &layer;
    return nullptr;
}

} // namespace renderer::imaging
