// Methods are kept: going back and forth between two of them costs nothing.
#include "experiment/viewer/stage.h"

#include "experiment/staging.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/methods/catalogue.h"

#include <algorithm>
#include <utility>

namespace experiment::viewer {

namespace methods = renderer::methods;
namespace shading = renderer::shading;

namespace {

// Both sides, and what a person goes back and forth between.
constexpr std::size_t most_kept = 8;

} // namespace

Stage::Stage(const Piece& piece,
             LoadedModel model,
             std::shared_ptr<const shading::Surface> surface,
             renderer::thickness::Progress progress)
    : piece_(piece), model_(std::move(model)), surface_(std::move(surface)),
      progress_(std::move(progress)), fields_(model_, progress_) {}

tl::expected<std::unique_ptr<Stage>, std::string>
Stage::open(const Exhibit& exhibit, const Piece& piece, renderer::thickness::Progress progress) {
    auto model = load_model(piece.scene, exhibit.folder);
    if (!model)
        return tl::unexpected(model.error());
    model->mesh = renderer::geometry::along_morton_curve(model->mesh); // as for stimuli
    auto surface = shading::Surface::upload(model->mesh);
    if (!surface)
        return tl::unexpected(surface.error());
    return std::unique_ptr<Stage>(
        new Stage(piece, std::move(*model), std::move(*surface), std::move(progress)));
}

tl::expected<methods::Method*, std::string> Stage::method(const Side& side) {
    auto found = std::ranges::find(entries_, side, &Entry::side);
    if (found == entries_.end()) {
        auto made = make(side);
        if (entries_.size() == most_kept)
            entries_.erase(entries_.begin());
        entries_.push_back({side, std::move(made)});
    } else {
        std::rotate(found, found + 1, entries_.end());
    }
    const auto& made = entries_.back().made;
    if (!made)
        return tl::unexpected(made.error());
    return made->get();
}

Stage::Made Stage::make(const Side& side) {
    const methods::Subject subject{
        .mesh = model_.mesh,
        .surface = surface_,
        .material = piece_.material,
        .placement = staged(piece_.scene, sphere(), 1).placement,
        .field = [&](const auto& options) { return fields_.field(options); },
        .progress = progress_};
    return methods::prepare_method(side.method, side.dials, subject);
}

} // namespace experiment::viewer
