// What is measured, and how: a scene of a study, some of its lights, and the settings.
#pragma once

#include "experiment/cost/contestants.h"
#include "experiment/cost/cost_report.h"
#include "experiment/cost/truth.h"
#include "experiment/models.h"
#include "protocols/study.h"

#include <functional>
#include <string>
#include <vector>

namespace experiment::cost {

struct MeasureOptions {
    Sweep sweep;
    int size = 240;            ///< pixels along the longer edge of pictures that are compared
    int samples = 4;           ///< of each of their pixels
    int rounds = 7;            ///< of timed frames
    bool by_processor = false; ///< frames are timed by the processor's time, not the clock
    int held_out_lights = 6;   ///< directions that thickness is compared under
    TruthPlaces truth;
    Wish wish;
};

/// Told what is done, and the fraction of it that is.
using Reporting = std::function<void(const std::string& what, double fraction)>;

/// Told what a person should know of a result.
using Remarking = std::function<void(const std::string&)>;

/// Everything lives at least as long as the measurement.
struct SceneCase {
    const protocols::Study& study;
    protocols::Study small; ///< the same with the pictures that are compared
    const protocols::Scene& scene;
    const std::vector<protocols::Variant>& variants;
    const LoadedModel& model; ///< its vertices along the Morton curve
    const MeasureOptions& options;
};

/// `study` with pictures of at most `longer_edge` pixels.
protocols::Study at_size(protocols::Study study, int longer_edge);

} // namespace experiment::cost
