// Smaller pictures keep the study's proportions.
#include "experiment/cost/scene_case.h"

#include <algorithm>
#include <cmath>

namespace experiment::cost {

protocols::Study at_size(protocols::Study study, int longer_edge) {
    const double scale =
        std::min(1.0, static_cast<double>(longer_edge) / std::max(study.width, study.height));
    study.width = std::max(1, static_cast<int>(std::lround(scale * study.width)));
    study.height = std::max(1, static_cast<int>(std::lround(scale * study.height)));
    return study;
}

} // namespace experiment::cost
