// pairlight thickness: how much material lies between a model's vertices and the light, as a table.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/model_options.h"
#include "experiment/directions_file.h"
#include "experiment/models.h"
#include "experiment/progress.h"
#include "renderer/geometry/mesh.h"
#include "renderer/harmonics/basis.h"
#include "renderer/thickness/thickness_field.h"

#include <fmt/format.h>

#include <cstddef>
#include <memory>

namespace experiment::commands {

namespace thickness = renderer::thickness;

namespace {

struct Options {
    std::string model;
    std::string directions;
    thickness::Kind kind = thickness::Kind::Sum;
    bool exact = false;
    int bands = 5;
    int samples = 1024;
    double mm_per_unit = 1;
    renderer::geometry::Holes holes = renderer::geometry::Holes::Refuse;
    std::string csv;
    Voice voice;
};

/// Thickness in model units, [vertex * directions + direction], traced or from n^2 coefficients.
std::vector<double> measured(const Options& options,
                             const renderer::geometry::Mesh& mesh,
                             const std::vector<glm::dvec3>& directions) {
    if (options.exact)
        return value_or_stop(thickness::trace_thickness(mesh, options.kind, directions));
    ProgressBar bar("tracing", !options.voice.quiet);
    const auto field = value_or_stop(thickness::compute_thickness_field(
        mesh, {.kind = options.kind, .bands = options.bands, .directions = options.samples},
        [&](double fraction) { bar.update(fraction); }));
    std::vector<double> values(mesh.positions.size() * directions.size());
    std::vector<double> basis(static_cast<std::size_t>(options.bands * options.bands));
    for (std::size_t k = 0; k < directions.size(); ++k) {
        renderer::harmonics::evaluate(options.bands, directions[k], basis);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            values[v * directions.size() + k] =
                thickness::reconstruct(field, v, basis, options.bands);
    }
    return values;
}

std::string thickness_csv(const renderer::geometry::Mesh& mesh,
                          std::size_t directions,
                          const std::vector<double>& values,
                          double mm_per_unit) {
    const auto normals = renderer::geometry::vertex_normals(mesh);
    std::string table = "vertex,x,y,z,nx,ny,nz,direction,thickness\n";
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        for (std::size_t k = 0; k < directions; ++k) {
            const auto& p = mesh.positions[v];
            const auto& n = normals[v];
            fmt::format_to(std::back_inserter(table), "{},{},{},{},{},{},{},{},{}\n", v, p.x, p.y,
                           p.z, n.x, n.y, n.z, k, values[v * directions + k] * mm_per_unit);
        }
    return table;
}

} // namespace

void add_thickness(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "thickness", "How much material lies between a model's vertices and the light, as CSV");
    command.add_option("MODEL", options->model, "A model file, a model's name, or a body")
        .required();
    command
        .add_option("--directions", options->directions,
                    "CSV with columns x,y,z: unit vectors toward the light")
        .required();
    command.add_choice("--kind", options->kind, "Which length counts",
                       {{"sum", thickness::Kind::Sum},
                        {"first", thickness::Kind::First},
                        {"span", thickness::Kind::Span}});
    auto exact = command.add_flag("--exact", options->exact, "Trace every direction asked for");
    command
        .add_option("--bands", options->bands, "Reconstruct from this many bands, n^2 coefficients")
        .within(1, 6)
        .shows_default()
        .excludes(exact);
    command
        .add_option("--mm-per-unit", options->mm_per_unit,
                    "Millimetres to a model unit; without it, model units")
        .within(1e-9, 1e9);
    add_holes(command, options->holes);
    command.add_option("--csv", options->csv,
                       "The file to write; without it, or with -, standard output");
    add_voice(command, options->voice);
    command.runs([options] {
        const auto directions = value_or_stop(read_directions(options->directions));
        const auto model =
            value_or_stop(load_model(options->model, StudyFolder{"."}, options->holes));
        for (const auto& remark : model.remarks)
            options->voice.remark(remark);
        const auto values = measured(*options, model.mesh, directions);
        deliver(thickness_csv(model.mesh, directions.size(), values, options->mm_per_unit),
                options->csv, {model.file, options->directions});
    });
}

} // namespace experiment::commands
