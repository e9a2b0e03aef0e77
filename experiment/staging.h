// A study's words about a scene and its lights, as the renderer's values.
#pragma once

#include "protocols/study.h"
#include "renderer/geometry/mesh.h"
#include "renderer/scene.h"

#include <vector>

namespace experiment {

/// The diameter of the model's bounding sphere in the world.
renderer::Millimetres diameter_of(const protocols::Scene& scene,
                                  const renderer::geometry::BoundingSphere& model);

/// The model on its turntable before the camera; material and lights are left to whoever asks.
/// `aspect` is the picture's width over its height.
renderer::Scene staged(const protocols::Scene& scene,
                       const renderer::geometry::BoundingSphere& model,
                       double aspect);

/// The variant's lights, which are given in the camera's view axes, in the world.
std::vector<renderer::Light> lights_of(const protocols::Variant& variant,
                                       const renderer::Camera& camera);

} // namespace experiment
