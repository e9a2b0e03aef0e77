// The path-traced picture of a scene under a light: one that is there already, or one of so many
// seconds.
#pragma once

#include "experiment/models.h"
#include "experiment/study_folder.h"
#include "protocols/study.h"
#include "renderer/imaging/linear_image.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace experiment::cost {

struct Truth {
    renderer::imaging::LinearImage image;
    /// Root mean square standard error over the root mean square light, over the object's pixels:
    /// half of the difference between the two halves of its samples.
    double noise_floor = 0;
    std::string words; ///< what it is: "240 x 240, 512 samples a pixel, made in 20 s"
};

struct TruthPlaces {
    StudyFolder study;         ///< whose reference/<scene>/<variant>.exr is taken if it is there
    std::filesystem::path own; ///< else <own>/<scene>/<variant>.exr, which is kept
    double seconds = 20;       ///< to make it; 0: only what is there already
};

/// `small` is the study at the size of the pictures that are to be made.
/// Nothing when there is none and no time to make one.
/// Errors: a file that is of something else; what the tracer refuses; files that cannot be written.
tl::expected<std::optional<Truth>, std::string>
truth_of(const protocols::Study& study,
         const protocols::Study& small,
         const protocols::Scene& scene,
         const protocols::Variant& variant,
         const LoadedModel& model,
         const TruthPlaces& places,
         const std::function<void(double)>& progress);

} // namespace experiment::cost
