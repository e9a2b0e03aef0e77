// From the viewer's state to the scene that is drawn.
#pragma once

#include "experiment/viewer/viewer_state.h"
#include "renderer/geometry/mesh.h"
#include "renderer/scene.h"

#include <glm/mat3x3.hpp>

namespace experiment::viewer {

/// Columns: the eye's right, up and backward in the world.
glm::dmat3 world_from_view(const protocols::Scene& scene, const Orbit& orbit);

/// The scene as the eye sees it: the model stands where the study puts it, the variant's lights
/// stand in the world as the scene's own camera would see them, turned as they have been, and only
/// the eye has walked.  `aspect` is the picture's width over its height.
renderer::Scene seen(const ViewerState& state,
                     const Exhibit& exhibit,
                     const renderer::geometry::BoundingSphere& model,
                     double aspect);

} // namespace experiment::viewer
