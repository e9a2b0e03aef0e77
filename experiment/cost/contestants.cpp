// Sweeps are data of the methods' descriptions; here they only become complete.
#include "experiment/cost/contestants.h"

#include "protocols/contract.h"
#include "renderer/methods/catalogue.h"
#include "renderer/methods/shared_dials.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace experiment::cost {

namespace methods = renderer::methods;

using methods::Description;
using methods::Dials;

namespace {

bool has_law(const Description& method) {
    return std::ranges::find(method.dials, methods::law_dial().name, &methods::Dial::name) !=
           method.dials.end();
}

Setting setting_of(const Description& method, Dials changed, const std::string& law) {
    std::vector<std::string> words;
    for (const auto& [dial, value] : changed)
        words.push_back(fmt::format("{} {}", dial, methods::text_of(value)));
    if (has_law(method))
        changed.insert_or_assign(methods::law_dial().name, law);
    auto dials = methods::complete_for(method.name, changed);
    EXPECTS(dials.has_value()); // a description knows its own dials: tests go through all of them
    return {&method, std::move(*dials), fmt::format("{}", fmt::join(words, ", ")), 1};
}

tl::expected<std::vector<const Description*>, std::string>
named(const std::vector<std::string>& names) {
    std::vector<const Description*> found;
    for (const auto& method : methods::catalogue())
        if (names.empty() || std::ranges::find(names, method.name) != names.end())
            found.push_back(&method);
    for (const auto& name : names)
        if (methods::find_method(name) == nullptr) {
            std::vector<std::string> known;
            for (const auto& method : methods::catalogue())
                known.push_back(method.name);
            return tl::unexpected(fmt::format("--methods {}: no method is called so; there are {}",
                                              name, fmt::join(known, ", ")));
        }
    return found;
}

} // namespace

std::string level_words(int one_of) {
    return fmt::format("triangles 1/{}", one_of);
}

tl::expected<std::vector<Setting>, std::string> settings_of(const Sweep& sweep) {
    const auto found = named(sweep.methods);
    if (!found)
        return tl::unexpected(found.error());
    std::vector<Setting> settings;
    for (const auto* method : *found) {
        const auto preset = setting_of(*method, {}, sweep.law);
        settings.push_back(preset);
        if (sweep.presets_only)
            continue;
        for (const auto& changed : method->sweep)
            settings.push_back(setting_of(*method, changed, sweep.law));
        for (const int one_of : std::set(sweep.one_of.begin(), sweep.one_of.end()))
            if (one_of > 1)
                settings.push_back({preset.method, preset.dials, level_words(one_of), one_of});
    }
    return settings;
}

Setting preset_of(std::string_view method, const std::string& law) {
    const auto* description = methods::find_method(method);
    EXPECTS(description != nullptr);
    return setting_of(*description, {}, law);
}

Row row_of(const Contestant& contestant) {
    const auto& setting = contestant.setting;
    Row row{.method = setting.method->name,
            .label = setting.method->label,
            .dials = {},
            .setting = setting.words,
            .vertices = contestant.vertices,
            .triangles = contestant.triangles,
            .mesh_bytes = contestant.mesh_bytes,
            .precompute_seconds = contestant.precompute_seconds,
            .lights = {}};
    for (const auto& [dial, value] : setting.dials)
        row.dials.emplace(dial, methods::text_of(value));
    return row;
}

} // namespace experiment::cost
