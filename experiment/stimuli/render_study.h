// Makes a study's stimuli: renders what its manifest does not hold yet, and checks what came from
// elsewhere.
#pragma once

#include "experiment/read_study.h"
#include "experiment/stimuli/manifest.h"

#include <tl/expected.hpp>

#include <functional>
#include <string>
#include <vector>

namespace experiment::stimuli {

struct RenderOptions {
    std::vector<std::string> only_scenes; ///< empty: all
    int samples = 16;                     ///< antialiasing: draws per picture
};

struct RenderSummary {
    int rendered = 0;
    int up_to_date = 0;
    int own_images = 0;
    std::vector<std::string> remarks; ///< what was repaired, retried or dimmed on the way
};

/// What is being done, and how much of the whole is done, 0..1.
using RenderProgress = std::function<void(const std::string& what, double fraction)>;

/// Writes stimuli/<scene>/<variant>/<condition>.png (16 bit, brightness equalised within each scene
/// and variant, over the surround) and .exr (linear, as rendered), and the manifest after every
/// scene, so that an interruption costs one scene.
/// Errors: a model that is missing or cannot be used, no OpenGL, a black picture, a folder that
///         cannot be written, an own image that is missing or of another size; names file and
///         remedy.
tl::expected<RenderSummary, std::string> render_study(const LoadedStudy& loaded,
                                                      const RenderOptions& options,
                                                      const RenderProgress& progress);

/// The manifest of a study; an empty one where nothing was rendered yet.
tl::expected<Manifest, std::string> read_manifest(const StudyFolder& folder);

} // namespace experiment::stimuli
