// Which bands of a thickness field a picture uses: a fixed number, as few as leave it unchanged to
// the eye, or the paper's preset; changes of their number are faded.
#pragma once

#include "renderer/methods/attenuation.h"
#include "renderer/methods/thickness_pass.h"
#include "renderer/scene.h"
#include "renderer/thickness/band_choice.h"
#include "renderer/thickness/band_fade.h"
#include "renderer/thickness/thickness_field.h"

#include <memory>
#include <optional>
#include <string>

namespace renderer::methods {

enum class BandChooser {
    Fixed,
    Tolerance, ///< the fewest whose predicted change of brightness is within the tolerance
    Paper      ///< 5 with the light behind the object, else 2  [SHSS]
};

struct BandSettings {
    BandChooser chooser = BandChooser::Fixed;
    int bands = 5; ///< the number that is fixed, else the most that may be used
    double tolerance = thickness::invisible_change;
};

class BandPlan {
  public:
    /// `field` has the bands, and its normal bins where the tolerance chooses.
    BandPlan(const BandSettings& settings,
             const Attenuation& attenuation,
             std::shared_ptr<const thickness::ThicknessField> field);

    /// The weights for this light and view, `seconds` after the last call.  Lights are taken as
    /// seen from the centre of the body.
    BandWeights weights(const Scene& scene, double seconds);

    /// What was chosen last, and why; empty for a fixed number.
    std::string decision() const;

  private:
    thickness::BandChoice choose(const Scene& scene) const;

    BandSettings settings_;
    Attenuation attenuation_;
    std::shared_ptr<const thickness::ThicknessField> field_;
    std::optional<thickness::BandChoice> choice_;
    std::optional<thickness::BandFade> fade_;
};

} // namespace renderer::methods
