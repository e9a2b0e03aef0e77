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

/// Who drew a picture that the path tracer made in a run with `renderer`, as the manifest has it.
std::string path_tracer_beside(const std::string& renderer);

/// The renderer of the run in which a picture was made, from who drew it.
std::string renderer_of_run(const std::string& drawn_by);

} // namespace experiment::stimuli
