// The reference as one more way to draw a scene: from a scene to a picture, and how sure it is.
#pragma once

#include "renderer/reference/convergence.h"

#include <cstdint>
#include <functional>

namespace renderer::reference {

struct ReferencePicture {
    imaging::LinearImage image;          ///< as every method draws it: premultiplied by coverage
    imaging::LinearImage standard_error; ///< of each pixel and channel
    Halves halves;                       ///< two pictures without a sample in common: noise floors
    Outcome outcome;
    std::uint32_t samples = 0; ///< of each pixel
};

struct ReferenceRun {
    ReferenceSettings settings;
    StopRule rule;
    std::uint64_t seed = 1;
};

/// Renders until the rule is met.  `progress` is told the fraction done, 0..1.
/// Errors: those of `picture_of_scene` and `render`.
Expected<ReferencePicture> reference_picture(const geometry::Mesh& mesh,
                                             const renderer::Scene& scene,
                                             int width,
                                             int height,
                                             const ReferenceRun& run = {},
                                             const std::function<void(double)>& progress = {});

} // namespace renderer::reference
