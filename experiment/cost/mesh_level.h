// A scene's mesh, as it is or with fewer triangles, and everything that methods are prepared from
// on it.
#pragma once

#include "experiment/cost/contestants.h"
#include "experiment/cost/shared_transfers.h"
#include "experiment/models.h"
#include "experiment/traced_fields.h"
#include "renderer/methods/description.h"
#include "renderer/scene.h"
#include "renderer/shading/surface.h"

#include <tl/expected.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace experiment::cost {

class MeshLevel {
  public:
    /// `seen` is the scene as it is, whatever the mesh: material and placement are the same on
    /// every level.  `seconds` were spent on the mesh: every setting on it is charged with them.
    /// Needs a current OpenGL 4.5 context.  Errors: those of `Surface::upload`.
    static tl::expected<std::unique_ptr<MeshLevel>, std::string>
    upload(LoadedModel model, const renderer::Scene& seen, double seconds);

    /// Errors: what the method refuses to be made from.
    tl::expected<Contestant, std::string> make(const Setting& setting);

    /// What was mended on the mesh, and said of the fields that were traced on it.
    const std::vector<std::string>& remarks() const { return model_.remarks; }

  private:
    MeshLevel(LoadedModel model,
              const renderer::Scene& seen,
              double seconds,
              std::shared_ptr<const renderer::shading::Surface> surface);

    LoadedModel model_;
    renderer::Scene seen_;
    double seconds_;
    std::shared_ptr<const renderer::shading::Surface> surface_;
    TracedFields fields_;
    SharedTransfers transfers_;
};

/// Calls `visit` for the model as it is, of which one of 1 triangles is kept, then for every other
/// number of `one_of`, from the finest to the coarsest; each level is gone before the next.
/// A mesh that cannot be simplified so far is a remark, and no level.
/// Errors: those of `MeshLevel::upload` and of `visit`.
tl::expected<void, std::string> for_each_level(
    const LoadedModel& model,
    const renderer::Scene& seen,
    std::vector<int> one_of,
    const std::function<tl::expected<void, std::string>(int one_of, MeshLevel& level)>& visit,
    const std::function<void(const std::string&)>& remark);

} // namespace experiment::cost
