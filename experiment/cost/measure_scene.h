// Everything that settings cost on one scene, and how far they are off under each of its lights.
#pragma once

#include "experiment/cost/cost_report.h"
#include "experiment/cost/truth.h"
#include "experiment/models.h"
#include "protocols/study.h"

#include <tl/expected.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace experiment::cost {

struct MeasureOptions {
    std::vector<std::string> methods; ///< by their names; empty: all
    bool presets_only = false;        ///< nothing of the methods' sweeps
    std::string law = "physical";     ///< of every method that has one
    int size = 240;            ///< pixels along the longer edge of pictures that are compared
    int samples = 4;           ///< of each of their pixels
    int rounds = 7;            ///< of timed frames
    bool by_processor = false; ///< frames are timed by the processor's time, not the clock
    int held_out_lights = 6;   ///< directions that thickness is compared under
    TruthPlaces truth;
    Wish wish;
};

/// Told what is done, and the fraction of the scene that is.
using Reporting = std::function<void(const std::string& what, double fraction)>;

/// Prepares every setting, draws them in turns, compares their pictures and chooses.
/// Needs a current OpenGL 4.5 context.  A setting that cannot be made for this scene is a remark.
/// Errors: an unknown material; a mesh that rays cannot be trusted with; those of `truth_of`;
/// OpenGL's own.
tl::expected<SceneCost, std::string> measure_scene(const protocols::Study& study,
                                                   const protocols::Scene& scene,
                                                   const std::vector<protocols::Variant>& variants,
                                                   LoadedModel model,
                                                   const MeasureOptions& options,
                                                   const Reporting& report);

} // namespace experiment::cost
