// A model by itself gets one scene, and the lights the paper's pictures have.
#include "experiment/viewer/exhibit.h"

#include "experiment/materials.h"
#include "experiment/read_study.h"
#include "renderer/expected.h"
#include "renderer/geometry/model_library.h"
#include "renderer/materials.h"
#include "renderer/methods/catalogue.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <filesystem>

namespace experiment::viewer {

namespace fs = std::filesystem;
namespace methods = renderer::methods;

using renderer::Expected;

namespace {

void add_methods(Exhibit& exhibit) {
    for (const auto& method : methods::catalogue())
        if (const auto dials = methods::complete_for(method.name, {}))
            exhibit.choices.push_back({method.label, method.name, *dials});
}

Expected<renderer::Material> measured(const std::string& name) {
    if (const auto material = renderer::measured_material(name))
        return *material;
    return tl::unexpected(fmt::format("no material is called \"{}\", expected one of {}", name,
                                      fmt::join(renderer::measured_names(), ", ")));
}

void add_conditions(const protocols::Study& study, Exhibit& exhibit) {
    std::vector<std::string> own;
    for (const auto& condition : study.conditions)
        if (const auto* rendering = std::get_if<protocols::Rendering>(&condition.source))
            exhibit.choices.push_back({condition.label, rendering->method, rendering->dials});
        else
            own.push_back(condition.id.value);
    if (!own.empty())
        exhibit.remarks.push_back(fmt::format(
            "conditions that are pictures made elsewhere are left out: {}", fmt::join(own, ", ")));
}

Expected<void> add_pieces(const LoadedStudy& loaded, Exhibit& exhibit) {
    for (const auto& scene : loaded.study.scenes) {
        if (scene.model.empty())
            continue;
        const auto material = material_of(loaded.study, scene);
        if (!material)
            return tl::unexpected(
                fmt::format("scene \"{}\": no material \"{}\"", scene.id.value, scene.material));
        exhibit.pieces.push_back({scene, *material});
    }
    if (exhibit.pieces.empty())
        return tl::unexpected(
            fmt::format("{}: none of its scenes has a model, expected one to view",
                        loaded.folder.study_file().string()));
    return {};
}

Expected<Exhibit> exhibit_of(const LoadedStudy& loaded) {
    Exhibit exhibit{.name = loaded.study.title.empty() ? loaded.study.id : loaded.study.title,
                    .folder = loaded.folder,
                    .variants = protocols::shown_variants(loaded.study),
                    .surround = loaded.study.surround.code};
    if (const auto added = add_pieces(loaded, exhibit); !added)
        return tl::unexpected(added.error());
    add_conditions(loaded.study, exhibit);
    add_methods(exhibit);
    return exhibit;
}

protocols::Variant lit_from(const char* id, const char* label, std::array<double, 3> direction) {
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    for (auto& coordinate : direction)
        coordinate /= length;
    return {.id = {id}, .label = label, .lights = {{.to_light = direction}}};
}

Expected<Exhibit> exhibit_of_model(const std::string& name, const ModelOptions& options) {
    const StudyFolder folder{"."};
    const auto model = renderer::geometry::find_model(name, {folder.root, model_folders(folder)});
    if (!model)
        return tl::unexpected(model.error());
    const auto material = measured(options.material);
    if (!material)
        return tl::unexpected(material.error());
    Exhibit exhibit{.name = fs::path(name).stem().string(),
                    .folder = folder,
                    .variants = {lit_from("back", "from behind", {0.3, 0.3, -1}),
                                 lit_from("left", "from the left", {-1, 0.3, 0.3}),
                                 lit_from("front", "from the front", {0.3, 0.5, 1})}};
    exhibit.pieces.push_back({{.id = {exhibit.name},
                               .label = exhibit.name,
                               .model = name,
                               .diameter_mm = options.diameter_mm,
                               .material = options.material,
                               .may_have_holes = true}, // any model opens
                              *material});
    add_methods(exhibit);
    return exhibit;
}

} // namespace

Expected<Exhibit> open_exhibit(const std::string& name, const ModelOptions& options) {
    if (!is_study(name))
        return exhibit_of_model(name, options);
    return read_study(name).and_then(exhibit_of);
}

} // namespace experiment::viewer
