// From light without bounds to light a display can show, by a curve that is named.
#pragma once

#include "renderer/imaging/linear_image.h"

#include <string>
#include <vector>

namespace experiment::commands {

/// How far light is lifted, and how what is too bright is brought below 1.
struct ToneCurve {
    enum class Kind {
        Clip,    ///< light above 1 becomes 1
        Reinhard ///< each colour keeps its hue: its luminance Y becomes Y / (1 + Y)
    };
    Kind kind = Kind::Clip;
    double exposure_stops = 0; ///< light is multiplied by 2 to this power first
};

/// "clip, exposure +0.5 stops"
std::string text_of(const ToneCurve& curve);

struct ToneMapped {
    renderer::imaging::LinearImage image; ///< every channel 0..1
    double clipped = 0;                   ///< share of pixels with a channel cut at 1, or at 0
};

/// `opaque` is a picture that covers every pixel.  EXPECTS numbers, not NaN.
/// Source: [Reinhard2002, eq. 3]
ToneMapped tone_mapped(const renderer::imaging::LinearImage& opaque, const ToneCurve& curve);

} // namespace experiment::commands
