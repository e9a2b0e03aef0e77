// Light, brought within a display's reach.
#include "experiment/commands/tone_curve.h"

#include "protocols/contract.h"
#include "renderer/imaging/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace experiment::commands {

std::string text_of(const ToneCurve& curve) {
    return fmt::format("{}, exposure {:+} stops",
                       curve.kind == ToneCurve::Kind::Clip ? "clip" : "reinhard",
                       curve.exposure_stops);
}

ToneMapped tone_mapped(const renderer::imaging::LinearImage& opaque, const ToneCurve& curve) {
    ToneMapped mapped{opaque, 0};
    const auto lift = static_cast<float>(std::exp2(curve.exposure_stops));
    std::size_t cut = 0;
    for (auto& pixel : mapped.image.pixels) {
        EXPECTS(!std::isnan(pixel.r) && !std::isnan(pixel.g) && !std::isnan(pixel.b));
        float scale = lift;
        if (curve.kind == ToneCurve::Kind::Reinhard) {
            const double luminance = lift * std::max(0.0, renderer::imaging::luminance(pixel));
            scale = static_cast<float>(lift / (1 + luminance));
        }
        bool is_cut = false;
        for (auto* channel : {&pixel.r, &pixel.g, &pixel.b}) {
            const float light = *channel * scale;
            *channel = std::clamp(light, 0.0F, 1.0F);
            is_cut = is_cut || *channel != light;
        }
        cut += is_cut ? 1 : 0;
    }
    if (!mapped.image.pixels.empty())
        mapped.clipped = static_cast<double>(cut) / static_cast<double>(mapped.image.pixels.size());
    return mapped;
}

} // namespace experiment::commands
