// The settings of a sweep made ready on one scene, each charged as if it were alone.
#pragma once

#include "experiment/cost/scene_case.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace experiment::cost {

struct Prepared {
    Contestant exact, bare; ///< what the others are measured by, on the whole mesh
    std::vector<Contestant> contestants;
};

/// Needs a current OpenGL 4.5 context.  A setting that cannot be made for this scene, and a mesh
/// that cannot be simplified so far, are remarks.
/// Errors: a name that no method has; an unknown material; what `exact` and `bare` refuse.
tl::expected<Prepared, std::string>
prepare(const SceneCase& measured, const Reporting& report, const Remarking& remark);

} // namespace experiment::cost
