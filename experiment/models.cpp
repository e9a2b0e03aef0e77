// Looking, reading, repairing; the file's digest goes into the pictures' recipes.
#include "experiment/models.h"

#include "experiment/read_study.h"
#include "experiment/text_files.h"
#include "protocols/digest.h"
#include "renderer/geometry/model_library.h"

#include <fmt/format.h>

#include <filesystem>
#include <variant>

namespace experiment {

namespace fs = std::filesystem;
namespace geometry = renderer::geometry;

namespace {

tl::expected<stimuli::ModelRecord, std::string> record_of(const geometry::Model& model) {
    if (const auto* body = std::get_if<geometry::Body>(&model))
        return stimuli::ModelRecord{.file = "body " + body->name};
    const auto& file = std::get<fs::path>(model);
    const auto bytes = read_text_file(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    return stimuli::ModelRecord{.file = file.filename().string(),
                                .sha256 = protocols::sha256_hexadecimal(*bytes)};
}

} // namespace

tl::expected<LoadedModel, std::string>
load_model(const std::string& name, const StudyFolder& folder, geometry::Holes holes) {
    const auto model = geometry::find_model(name, {folder.root, model_folders(folder)});
    if (!model)
        return tl::unexpected(model.error());
    auto record = record_of(*model);
    if (!record)
        return tl::unexpected(record.error());
    auto mesh = geometry::load_model(*model);
    if (!mesh)
        return tl::unexpected(mesh.error());
    auto prepared = geometry::prepare(std::move(*mesh), record->file, {.holes = holes});
    if (!prepared)
        return tl::unexpected(prepared.error());
    record->vertices = prepared->mesh.positions.size();
    record->triangles = prepared->mesh.triangles.size();
    const auto* file = std::get_if<fs::path>(&*model);
    auto remarks = describe(prepared->repairs);
    if (prepared->report.boundary.count > 0)
        remarks.push_back(
            fmt::format("the surface has holes: {}; inside is where it winds more than half around",
                        describe_openings(prepared->report)));
    return LoadedModel{std::move(prepared->mesh), std::move(*record), std::move(remarks),
                       file != nullptr ? *file : fs::path()};
}

tl::expected<LoadedModel, std::string> load_model(const protocols::Scene& scene,
                                                  const StudyFolder& folder) {
    return load_model(scene.model, folder,
                      scene.may_have_holes ? geometry::Holes::ByWinding : geometry::Holes::Refuse);
}

} // namespace experiment
