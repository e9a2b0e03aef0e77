// Steps of one simplification; vertices in the order that is quickest to trace and to draw.
#include "experiment/cost/mesh_level.h"

#include "renderer/expected.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/geometry/simplify.h"
#include "renderer/shading/body_radiance.h"
#include "renderer/stopwatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace experiment::cost {

namespace geometry = renderer::geometry;
namespace methods = renderer::methods;
namespace shading = renderer::shading;

using renderer::Expected;

namespace {

LoadedModel with_mesh(const LoadedModel& model, const geometry::Mesh& mesh) {
    auto other = model;
    other.remarks.clear();
    other.mesh = geometry::along_morton_curve(mesh);
    other.record.vertices = other.mesh.positions.size();
    other.record.triangles = other.mesh.triangles.size();
    return other;
}

} // namespace

MeshLevel::MeshLevel(LoadedModel model,
                     const renderer::Scene& seen,
                     double seconds,
                     std::shared_ptr<const shading::Surface> surface)
    : model_(std::move(model)), seen_(seen), seconds_(seconds), surface_(std::move(surface)),
      fields_(model_, {}, FieldsKept::Nowhere),
      transfers_(model_.mesh, seen_.material.medium, shading::mm_per_unit(seen_.placement)) {}

Expected<std::unique_ptr<MeshLevel>>
MeshLevel::upload(LoadedModel model, const renderer::Scene& seen, double seconds) {
    return shading::Surface::upload(model.mesh).map([&](auto surface) {
        return std::unique_ptr<MeshLevel>(
            new MeshLevel(std::move(model), seen, seconds, std::move(surface)));
    });
}

Expected<Contestant> MeshLevel::make(const Setting& setting) {
    const methods::Subject subject{
        .mesh = model_.mesh,
        .surface = surface_,
        .material = seen_.material,
        .placement = seen_.placement,
        .field = [&](const auto& asked) { return fields_.field(asked); },
        .progress = {},
        .transfer = [&](const auto& asked) { return transfers_.field(asked); }};
    const renderer::Stopwatch watch;
    auto method = setting.method->prepare(setting.dials, subject);
    const double elapsed = seconds_ + watch.seconds();
    const auto alone = fields_.seconds_alone(elapsed + transfers_.seconds_saved());
    if (!method)
        return tl::unexpected(method.error());
    return Contestant{.setting = setting,
                      .method = std::move(*method),
                      .precompute_seconds = alone,
                      .vertices = model_.record.vertices,
                      .triangles = model_.record.triangles,
                      .mesh_bytes = surface_->bytes()};
}

Expected<void>
for_each_level(const LoadedModel& model,
               const renderer::Scene& seen,
               std::vector<int> one_of,
               const std::function<Expected<void>(int one_of, MeshLevel& level)>& visit,
               const std::function<void(const std::string&)>& remark) {
    const auto visit_mesh = [&](int share, LoadedModel with, double seconds) -> Expected<void> {
        auto level = MeshLevel::upload(std::move(with), seen, seconds);
        if (!level)
            return tl::unexpected(level.error());
        auto done = visit(share, **level);
        for (const auto& words : (*level)->remarks())
            remark(share == 1 ? words : fmt::format("{}: {}", level_words(share), words));
        return done;
    };
    if (auto done = visit_mesh(1, model, 0); !done)
        return done;
    std::erase(one_of, 1); // that was the whole mesh
    std::ranges::sort(one_of);
    one_of.erase(std::ranges::unique(one_of).begin(), one_of.end());
    double seconds = 0;
    std::optional<Expected<geometry::Simplifier>> simplifier;
    for (const int share : one_of) {
        const renderer::Stopwatch watch;
        if (!simplifier)
            simplifier = geometry::Simplifier::prepare(model.mesh);
        const auto simplified = simplifier->and_then([&](geometry::Simplifier& fine) {
            return fine.down_to(model.mesh.triangles.size() / static_cast<std::size_t>(share));
        });
        seconds += watch.seconds();
        if (!simplified)
            remark(fmt::format("{}: not measured: {}", level_words(share), simplified.error()));
        else if (auto done = visit_mesh(share, with_mesh(model, *simplified), seconds); !done)
            return done;
    }
    return {};
}

} // namespace experiment::cost
