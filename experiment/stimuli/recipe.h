// A picture's recipe: one digest of everything that goes into it, so that equal recipes are
// rendered once.
#pragma once

#include "experiment/stimuli/manifest.h"
#include "protocols/study.h"

#include <map>
#include <string>

namespace experiment::stimuli {

/// A rendering's dials by their names in the study file.
std::map<std::string, std::string> dials(const protocols::Rendering& rendering);

/// Digest over the program, the renderer, the model's file, and all that the study says of the
/// scene, the variant and every condition: brightness is matched between conditions, so a picture
/// depends on its neighbours too.
std::string recipe(const protocols::Study& study,
                   const protocols::Scene& scene,
                   const protocols::Variant& variant,
                   const ModelRecord& model,
                   const std::string& renderer,
                   int samples);

} // namespace experiment::stimuli
