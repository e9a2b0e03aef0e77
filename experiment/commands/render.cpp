// pairlight render: makes the stimuli; skips what the manifest says is up to date.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/steps.h"
#include "experiment/read_study.h"

#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

void add_render(Command& program) {
    struct Options {
        std::string study;
        stimuli::RenderOptions render;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto command = program.add_command("render", "Make the stimuli; skip what is up to date");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    command.add_option("--only", options->render.only_scenes, "Scenes to render; without it, all");
    add_voice(command, options->voice);
    command.runs([options] {
        const auto loaded = value_or_stop(read_study(options->study));
        const auto summary = render_stimuli(loaded, options->render, options->voice);
        fmt::print("{} pictures rendered, {} up to date, {} own images checked\n", summary.rendered,
                   summary.up_to_date, summary.own_images);
    });
}

} // namespace experiment::commands
