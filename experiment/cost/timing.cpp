// The light moving, then at rest; the bare model leads every round.
#include "experiment/cost/timing.h"

#include "experiment/stimuli/lit_scene.h"
#include "renderer/cost/frame_times.h"
#include "renderer/gpu/target.h"

#include <vector>

namespace experiment::cost {

using renderer::cost::FrameTimes;
using renderer::cost::Spread;

namespace {

Spread milliseconds(Spread s) {
    return {1000 * s.lower, 1000 * s.median, 1000 * s.upper};
}

} // namespace

tl::expected<void, std::string> time_frames(const SceneCase& measured,
                                            const Prepared& prepared,
                                            std::span<Row> rows,
                                            const Reporting& report) {
    const auto& study = measured.study;
    auto scene =
        stimuli::lit_scene(study, measured.scene, measured.variants.front(), measured.model.mesh);
    if (!scene)
        return tl::unexpected(scene.error());
    scene->lights.resize(1); // one light is what the moving one is measured with
    const auto target = renderer::gpu::Target::create(study.width, study.height);
    if (!target)
        return tl::unexpected(target.error());
    std::vector<renderer::cost::Turn> turns{{prepared.bare.method.get(), true}};
    for (const auto& contestant : prepared.contestants)
        for (const bool moves : {true, false})
            turns.push_back({contestant.method.get(), moves});
    const auto times =
        renderer::cost::take_turns(turns, *scene, *target, {.rounds = measured.options.rounds},
                                   [&](double done) { report("drawing frames in turns", done); });
    if (!times)
        return tl::unexpected(times.error());
    const auto chosen = [&](const FrameTimes& time) -> const std::vector<double>& {
        return measured.options.by_processor ? time.processor : time.clock;
    };
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const auto& moving = (*times)[1 + 2 * r];
        auto& row = rows[r];
        row.frame_ms = milliseconds(renderer::cost::spread_of(chosen(moving)));
        row.resting_ms = milliseconds(renderer::cost::spread_of(chosen((*times)[2 + 2 * r])));
        row.to_bare = renderer::cost::spread_of(
            renderer::cost::ratios(chosen(moving), chosen(times->front())));
        row.clock_ms = 1000 * renderer::cost::quantile(moving.clock, 0.5);
        const auto cost = prepared.contestants[r].method->cost();
        row.bytes_per_vertex = cost.bytes_per_vertex;
        row.bytes_per_light = cost.bytes_per_light;
    }
    return {};
}

} // namespace experiment::cost
