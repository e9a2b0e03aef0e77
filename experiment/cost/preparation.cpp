// Level by level, so that of all meshes only the whole one and another are in memory.
#include "experiment/cost/preparation.h"

#include "experiment/cost/mesh_level.h"
#include "experiment/stimuli/lit_scene.h"
#include "renderer/expected.h"
#include "renderer/methods/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

namespace experiment::cost {

namespace methods = renderer::methods;

using renderer::Expected;

namespace {

/// In this order one traced field serves whoever wants as many bands or fewer.
std::vector<std::size_t> most_bands_first(const std::vector<Setting>& settings) {
    std::vector<std::size_t> order(settings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto bands = [&](std::size_t i) {
        const auto found = settings[i].dials.find("bands");
        const auto* number =
            found == settings[i].dials.end() ? nullptr : std::get_if<std::int64_t>(&found->second);
        return number == nullptr ? std::int64_t{0} : *number;
    };
    std::ranges::stable_sort(order, std::ranges::greater(), bands);
    return order;
}

Expected<void> make_what_is_measured_by(MeshLevel& level, const std::string& law, Prepared& made) {
    for (const auto& [name, base] : {std::pair{methods::exact_method, &made.exact},
                                     std::pair{methods::bare_method, &made.bare}}) {
        auto contestant = level.make(preset_of(name, law));
        if (!contestant)
            return tl::unexpected(contestant.error());
        *base = std::move(*contestant);
    }
    return {};
}

} // namespace

Expected<Prepared>
prepare(const SceneCase& measured, const Reporting& report, const Remarking& remark) {
    const auto& sweep = measured.options.sweep;
    const auto settings = settings_of(sweep);
    if (!settings)
        return tl::unexpected(settings.error());
    const auto seen = stimuli::seen_scene(measured.study, measured.scene, measured.model.mesh);
    if (!seen)
        return tl::unexpected(seen.error());
    Prepared prepared;
    std::vector<std::optional<Contestant>> made(settings->size());
    std::size_t done = 0;
    const auto fill = [&](int one_of, MeshLevel& level) -> Expected<void> {
        if (one_of == 1)
            if (auto ready = make_what_is_measured_by(level, sweep.law, prepared); !ready)
                return ready;
        for (const auto i : most_bands_first(*settings)) {
            const auto& setting = (*settings)[i];
            if (setting.one_of != one_of)
                continue;
            report("preparing " + setting.method->name,
                   static_cast<double>(done++) / static_cast<double>(settings->size()));
            if (auto contestant = level.make(setting))
                made[i] = std::move(*contestant);
            else
                remark(fmt::format("{} {}: not measured: {}", setting.method->label, setting.words,
                                   contestant.error()));
        }
        return {};
    };
    const auto levels = sweep.presets_only ? std::vector<int>() : sweep.one_of;
    if (auto filled = for_each_level(measured.model, *seen, levels, fill, remark); !filled)
        return tl::unexpected(filled.error());
    for (auto& contestant : made)
        if (contestant)
            prepared.contestants.push_back(std::move(*contestant));
    return prepared;
}

} // namespace experiment::cost
