// Everything that settings cost on one scene, and how far they are off under each of its lights.
#pragma once

#include "experiment/cost/cost_report.h"
#include "experiment/cost/scene_case.h"
#include "experiment/models.h"
#include "protocols/study.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace experiment::cost {

/// Prepares every setting, draws them in turns, compares their pictures and chooses.
/// Needs a current OpenGL 4.5 context.  A setting that cannot be made for this scene, or one of
/// whose errors is no number, is a remark, and the others are measured.
/// Errors: an unknown material; a mesh that rays cannot be trusted with; those of `truth_of`;
/// OpenGL's own.
tl::expected<SceneCost, std::string> measure_scene(const protocols::Study& study,
                                                   const protocols::Scene& scene,
                                                   const std::vector<protocols::Variant>& variants,
                                                   LoadedModel model,
                                                   const MeasureOptions& options,
                                                   const Reporting& report);

} // namespace experiment::cost
