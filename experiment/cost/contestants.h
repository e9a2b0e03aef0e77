// The settings that are measured against each other, made ready to draw.
#pragma once

#include "experiment/cost/cost_report.h"
#include "renderer/methods/description.h"
#include "renderer/methods/method.h"

#include <tl/expected.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace experiment::cost {

/// A setting of a method; `dials` are complete.
struct Setting {
    const renderer::methods::Description* method = nullptr;
    renderer::methods::Dials dials;
    std::string words; ///< what is not preset
};

/// The presets of every method named (all when none is) and its sweep, under one law.
/// Errors: a name that no method has, with the names there are.
tl::expected<std::vector<Setting>, std::string>
settings_of(const std::vector<std::string>& methods, const std::string& law, bool presets_only);

/// A setting made ready.
struct Contestant {
    Setting setting;
    std::unique_ptr<renderer::methods::Method> method;
    std::optional<double> precompute_seconds;
};

/// The method of that name at its presets under that law, for comparison.
Setting preset_of(std::string_view method, const std::string& law);

/// Everything the table says of a setting before it has drawn.
Row row_of(const Contestant& contestant);

} // namespace experiment::cost
