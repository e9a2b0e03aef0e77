// One scene's model in video memory, and the methods made for it so far.
#pragma once

#include "experiment/models.h"
#include "experiment/traced_fields.h"
#include "experiment/viewer/exhibit.h"
#include "experiment/viewer/viewer_state.h"
#include "renderer/methods/method.h"
#include "renderer/shading/surface.h"
#include "renderer/thickness/thickness_field.h"

#include <tl/expected.hpp>

#include <memory>
#include <string>
#include <vector>

namespace experiment::viewer {

/// Needs a current OpenGL context, and has to be gone before that is.
class Stage {
  public:
    /// Reads the piece's model.  `progress` hears of all later work, and may end it by throwing:
    /// what was to be made is then not there, and can be asked for again.
    /// Errors: where the model was looked for, or what is wrong with it.
    static tl::expected<std::unique_ptr<Stage>, std::string>
    open(const Exhibit& exhibit, const Piece& piece, renderer::thickness::Progress progress);

    /// The method ready to draw; made when it is asked for the first time, and again when it has
    /// not been used for long.
    /// Errors: what the tracing or the method refuses; the same again without another try.
    tl::expected<renderer::methods::Method*, std::string> method(const Side& side);

    const renderer::geometry::BoundingSphere& sphere() const { return surface_->model_sphere(); }

    const LoadedModel& model() const { return model_; }

  private:
    using Made = tl::expected<std::unique_ptr<renderer::methods::Method>, std::string>;

    struct Entry {
        Side side;
        Made made;
    };

    Stage(const Piece& piece,
          LoadedModel model,
          std::shared_ptr<const renderer::shading::Surface> surface,
          renderer::thickness::Progress progress);

    Made make(const Side& side);

    Piece piece_;
    LoadedModel model_;
    std::shared_ptr<const renderer::shading::Surface> surface_;
    renderer::thickness::Progress progress_;
    TracedFields fields_;
    std::vector<Entry> entries_; ///< the one used last stands last
};

} // namespace experiment::viewer
