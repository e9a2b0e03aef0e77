// A light of the scene with the pictures that all others are compared with.
#pragma once

#include "experiment/cost/scene_case.h"
#include "renderer/imaging/linear_image.h"
#include "renderer/methods/method.h"
#include "renderer/scene.h"

#include <tl/expected.hpp>

#include <optional>
#include <string>
#include <vector>

namespace experiment::cost {

/// All of it on the whole mesh, whatever mesh a setting draws.
struct Lit {
    LightCase about;
    renderer::Scene scene;
    int width = 0, height = 0;
    renderer::imaging::LinearImage exact; ///< the same law with traced thickness
    std::optional<Truth> truth;
    std::vector<std::size_t> mask; ///< the body's pixels, in both
};

/// Every variant, its path-traced picture found or made.  `exact` draws the other.
/// Errors: those of `truth_of`; a body that covers no pixel; OpenGL's own.
tl::expected<std::vector<Lit>, std::string>
light_up(const SceneCase& measured, renderer::methods::Method& exact, const Reporting& report);

} // namespace experiment::cost
