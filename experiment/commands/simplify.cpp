// pairlight simplify: a model with fewer triangles, closed as it was.
#include "renderer/geometry/simplify.h"

#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/models.h"
#include "experiment/study_folder.h"
#include "renderer/geometry/off_file.h"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

namespace experiment::commands {

namespace {

struct Options {
    std::string model;
    int one_of = 0;            ///< triangles, one is kept; 0: `triangles` are
    std::size_t triangles = 0; ///< at most
    std::string out;
    Voice voice;
};

void run(const Options& options) {
    if ((options.one_of > 0) == (options.triangles > 0))
        throw CommandError("expected either --one-of or --triangles");
    if (!is_standard_output(options.out) &&
        std::filesystem::path(options.out).extension() != ".off")
        throw CommandError(fmt::format("{}: expected a name that ends in .off", options.out));
    const auto model = value_or_stop(load_model(options.model, StudyFolder{"."}));
    for (const auto& remark : model.remarks)
        options.voice.remark(remark);
    const auto asked = options.one_of > 0
                           ? model.mesh.triangles.size() / static_cast<std::size_t>(options.one_of)
                           : options.triangles;
    const auto fewer = renderer::geometry::simplify(model.mesh, asked);
    if (!fewer)
        throw CommandError(fmt::format("{}: {}", options.model, fewer.error()));
    options.voice.remark(fmt::format("{} of {} triangles, {} of {} vertices",
                                     fewer->triangles.size(), model.mesh.triangles.size(),
                                     fewer->positions.size(), model.mesh.positions.size()));
    deliver(renderer::geometry::off_text(*fewer), options.out, {model.file});
}

} // namespace

void add_simplify(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "simplify", "A closed model with fewer triangles, closed as it was, as OFF");
    command.add_option("MODEL", options->model, "A model file, a model's name or a body")
        .required();
    command
        .add_option("--one-of", options->one_of,
                    "Of so many triangles one is kept: 4 keeps a quarter")
        .within(1, 1e6);
    command.add_option("--triangles", options->triangles, "So many are kept, or one less")
        .within(4, 1e9);
    command.add_option("--out", options->out,
                       "The OFF file; without it, or with -, standard output");
    add_voice(command, options->voice);
    command.runs([options] { run(*options); });
}

} // namespace experiment::commands
