// A scene of a study under one of its lights, as the renderer takes it.
#pragma once

#include "protocols/study.h"
#include "renderer/geometry/mesh.h"
#include "renderer/scene.h"

#include <tl/expected.hpp>

#include <string>

namespace experiment::stimuli {

/// The model on its turntable, its material and the camera; its lights are still to come.
/// Errors: an unknown material.
tl::expected<renderer::Scene, std::string> seen_scene(const protocols::Study& study,
                                                      const protocols::Scene& scene,
                                                      const renderer::geometry::Mesh& mesh);

/// The same with the variant's lights.
tl::expected<renderer::Scene, std::string> lit_scene(const protocols::Study& study,
                                                     const protocols::Scene& scene,
                                                     const protocols::Variant& variant,
                                                     const renderer::geometry::Mesh& mesh);

} // namespace experiment::stimuli
