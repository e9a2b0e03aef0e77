// What `pairlight compare` writes: every measure under its name.
#pragma once

#include "renderer/imaging/errors.h"

#include <optional>
#include <string>

namespace experiment {

/// One comparison, and what the reference's own noise makes of the same measures.
struct Comparison {
    renderer::imaging::ImageErrors raw;
    renderer::imaging::ImageErrors equalised; ///< the picture scaled to the reference's brightness
    double gain = 1;                          ///< that scaling
    /// One half of the reference's samples against the other, where it keeps them.
    std::optional<renderer::imaging::ImageErrors> noise_floor;
    std::size_t pixels = 0;
    double pixels_per_degree = 0;
};

/// {"RMSE", "MAE", "relMSE", "PSNR", "SSIM", "LDR-FLIP", "HDR-FLIP", "equalised": {the same and
/// "gain"}, "noise_floor": {the same}, ...}.  An infinite PSNR is "inf".
std::string errors_json(const Comparison& comparison);

/// The same as a table for a person.
std::string errors_text(const Comparison& comparison);

} // namespace experiment
