// How far the thickness that a method draws is from the exact one, under light that it was not made
// for.
#pragma once

#include "renderer/cost/picture_error.h"
#include "renderer/expected.h"
#include "renderer/methods/method.h"
#include "renderer/scene.h"
#include "renderer/shading/attenuation.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace renderer::cost {

/// Pictures are compared pixel by pixel, so that methods may draw the body on a mesh of their own:
/// what counts is the exact thickness where the whole mesh is seen.
class HeldOutThickness {
  public:
    /// `exact` draws the truth: thickness of `scene`, its first light alone and moved to `lights`
    /// directions all around, turned at random by `seed`.
    /// Errors: those of `seen_thickness`.
    static Expected<HeldOutThickness> prepare(methods::Method& exact,
                                              shading::Law law,
                                              Scene scene,
                                              int width,
                                              int height,
                                              int lights,
                                              std::uint64_t seed);

    /// Root mean square of the difference over the root mean square of the truth, over all pixels
    /// and lights where both see the body.
    /// Errors: those of `seen_thickness`; pixels of the body that are no number; no pixel at all.
    Expected<double> error_of(methods::Method& method) const;

  private:
    struct Lit {
        Scene scene;
        std::vector<std::optional<double>> exact;
    };

    shading::Law law_ = shading::Law::Physical;
    int width_ = 0, height_ = 0;
    std::vector<Lit> lit_;
};

} // namespace renderer::cost
