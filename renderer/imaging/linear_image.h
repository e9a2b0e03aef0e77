// A picture in linear light, with how much of each pixel the object covers.
#pragma once

#include "renderer/units.h"

#include <vector>

namespace renderer::imaging {

/// Row-major, top row first; `pixels` are premultiplied by `coverage`, which is 0..1.
struct LinearImage {
    int width = 0, height = 0;
    std::vector<LinearRgb> pixels;
    std::vector<float> coverage;
};

} // namespace renderer::imaging
