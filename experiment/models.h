// A scene's model, from its name in a study file to a mesh that rays can be trusted with.
#pragma once

#include "experiment/stimuli/manifest.h"
#include "experiment/study_folder.h"
#include "protocols/study.h"
#include "renderer/geometry/mesh.h"
#include "renderer/geometry/mesh_repair.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace experiment {

/// Welded, closed unless it may have holes, facing outward; `remarks` say what was mended on the
/// way.
struct LoadedModel {
    renderer::geometry::Mesh mesh;
    stimuli::ModelRecord record;
    std::vector<std::string> remarks;
    std::filesystem::path file; ///< where it was found; empty for a body
};

/// `name` is a body's name, a name on the search path, or a path (from the study folder).
/// Errors: where it was looked for, or what is wrong with the mesh and where.
tl::expected<LoadedModel, std::string>
load_model(const std::string& name,
           const StudyFolder& folder,
           renderer::geometry::Holes holes = renderer::geometry::Holes::Refuse);

/// The model of a scene, which says whether it may have holes.
tl::expected<LoadedModel, std::string> load_model(const protocols::Scene& scene,
                                                  const StudyFolder& folder);

} // namespace experiment
