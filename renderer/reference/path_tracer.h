// Pictures by following light: the reference every shading method is measured against.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"
#include "renderer/reference/body.h"
#include "renderer/reference/film.h"
#include "renderer/reference/illumination.h"
#include "renderer/reference/walk.h"
#include "renderer/scene.h"

#include <functional>
#include <memory>

namespace renderer::reference {

/// How light is followed; no choice changes what the picture is on average.
struct TracerTactics {
    WalkTactics walk;
    /// A collision asks for the lights with a probability that falls with what they could add at
    /// most, or what a guess of them may miss: below this weight, in proportion.  0: always.
    double light_threshold = 0.1;
    /// Lines of sight are shared: as many paths follow each as there are lines in a pixel's batch,
    /// or twice as many.
    bool share_lines = true;
};

/// A translucent body, its light and who looks at it.
struct Picture {
    std::shared_ptr<const Body> body;
    Medium medium;
    Boundary boundary;
    Illumination illumination;
    Camera camera;
    std::string openings; ///< where the body's surface gapes, in words; empty where it is closed
};

/// Which parts of the study's conventions the reference takes over.
struct ReferenceSettings {
    Boundary boundary;
    double anisotropy = 0;
    Radians sun_half_angle{0};
};

/// The scene as the study's methods draw it: their medium, light and camera.  The ambient term has
/// no counterpart in transport; in its place stands the even sky under which a thick layer, whose
/// reflectance is k_di + k_sc, has the radiance I_a k_am.
/// Errors: those of `check_reachable`.
Expected<Picture> picture_of_scene(const geometry::Mesh& mesh,
                                   const renderer::Scene& scene,
                                   const ReferenceSettings& settings = {});

/// Adds one batch of samples to every pixel.  The film is the same, bit for bit, for any number of
/// threads.  `go_on` is asked now and then; when it says no, the film is left as it was and false
/// is returned.
/// Errors: EXPECTS a picture that `check_reachable` accepts.
bool add_batch(
    const Picture& picture,
    Film& film,
    const TracerTactics& tactics = {},
    const std::function<bool()>& go_on = [] { return true; });

} // namespace renderer::reference
