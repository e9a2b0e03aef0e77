// Which bands of a thickness field a picture uses: a fixed number, as few as leave it unchanged to
// the eye, or the paper's preset; changes of their number are faded.
#pragma once

#include "renderer/reconstruction/thickness_pass.h"
#include "renderer/scene.h"
#include "renderer/shading/attenuation.h"
#include "renderer/thickness/band_choice.h"
#include "renderer/thickness/band_fade.h"
#include "renderer/thickness/surface_sample.h"
#include "renderer/thickness/thickness_field.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace renderer::reconstruction {

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
    /// `field` has the bands.  Where the tolerance chooses, the change is reckoned at the vertices
    /// of `sample`, through the law; without one, from the field's normal bins, to first order.
    BandPlan(const BandSettings& settings,
             const shading::Attenuation& attenuation,
             std::shared_ptr<const thickness::ThicknessField> field,
             std::optional<thickness::SurfaceSample> sample = {});

    /// The weights for this light and view, `seconds` after the last call.  Lights are taken as
    /// seen from the centre of the body.
    BandWeights weights(const Scene& scene, double seconds);

    /// What was chosen last, and why; empty for a fixed number.
    std::string decision() const;

    /// By how much the choice changes the picture; nothing where it was not made by that.
    std::optional<double> predicted_change() const;

    /// Otherwise all bands are used.
    void let_choose(bool may) { may_choose_ = may; }

  private:
    thickness::BandChoice choose(const Scene& scene) const;
    std::vector<double> reckoned_changes(const Scene& scene) const;

    BandSettings settings_;
    shading::Attenuation attenuation_;
    std::shared_ptr<const thickness::ThicknessField> field_;
    std::optional<thickness::SurfaceSample> sample_;
    std::optional<thickness::BandChoice> choice_;
    std::optional<thickness::BandFade> fade_;
    bool may_choose_ = true;
};

} // namespace renderer::reconstruction
