// The settings that are measured against each other, made ready to draw.
#pragma once

#include "experiment/cost/cost_report.h"
#include "renderer/methods/description.h"
#include "renderer/methods/method.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace experiment::cost {

/// A setting of a method on the scene's mesh or a simplified one; `dials` are complete.
struct Setting {
    const renderer::methods::Description* method = nullptr;
    renderer::methods::Dials dials;
    std::string words; ///< what is not preset
    int one_of = 1;    ///< one of so many of the mesh's triangles is kept
};

/// "triangles 1/4".
std::string level_words(int one_of);

/// Which settings are measured.
struct Sweep {
    std::vector<std::string> methods; ///< by their names; empty: all
    std::string law = "physical";     ///< of every method that has one
    bool presets_only = false;        ///< nothing of what follows, nor of the methods' sweeps
    std::vector<int> one_of = {
        2, 4, 8}; ///< of so many triangles one is kept: meshes beside the whole one
};

/// The presets of every method, its sweep, and its presets on every simplified mesh.
/// Errors: a name that no method has, with the names there are.
tl::expected<std::vector<Setting>, std::string> settings_of(const Sweep& sweep);

/// A setting made ready.
struct Contestant {
    Setting setting;
    std::unique_ptr<renderer::methods::Method> method;
    std::optional<double> precompute_seconds;
    std::size_t vertices = 0, triangles = 0, mesh_bytes = 0; ///< as in `Row`
};

/// The method of that name at its presets under that law, for comparison.
Setting preset_of(std::string_view method, const std::string& law);

/// Everything the table says of a setting before it has drawn.
Row row_of(const Contestant& contestant);

} // namespace experiment::cost
