// pairlight check: whether a study can be run as it stands, and what to know before it is.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/models.h"
#include "experiment/read_study.h"
#include "experiment/session/words.h"
#include "experiment/stimuli/freshness.h"
#include "experiment/store/screened.h"
#include "experiment/store/sqlite_store.h"
#include "protocols/conformity.h"
#include "protocols/questions.h"
#include "protocols/schedule.h"
#include "protocols/session_length.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>

namespace experiment::commands {

namespace {

using protocols::Phase;
using protocols::Study;

bool has_rendered_conditions(const Study& study) {
    return std::ranges::any_of(study.conditions, [](const auto& condition) {
        return std::holds_alternative<protocols::Rendering>(condition.source);
    });
}

void say_what_is_asked(const Study& study) {
    const auto pairs = all_questions(study).size();
    const auto ways = shown_variants(study).size();
    fmt::print("{}: {} conditions{}, {} {}, {} to show each: {} pairs a sitting, {}\n", study.id,
               study.conditions.size(), study.plan.reference ? ", one of them the reference" : "",
               study.scenes.size(), study.scenes.size() == 1 ? "scene" : "scenes",
               ways == 1 ? "one way" : fmt::format("{} ways", ways),
               pairs * static_cast<std::size_t>(study.plan.repetitions),
               study.plan.sessions == 1
                   ? "one sitting"
                   : fmt::format("{} sittings, {} calendar days from one to the next or more",
                                 study.plan.sessions, study.plan.days_apart));
    if (!session::speaks(study.instructions.language))
        fmt::print("language: \"{}\"; the built-in pages will be in English, as they are in {} "
                   "only\n",
                   study.instructions.language, fmt::join(session::spoken_languages(), ", "));
}

/// People who passed the screening and have finished a sitting; empty where there are no votes.
std::optional<int> screened_so_far(const LoadedStudy& loaded) {
    if (!std::filesystem::exists(loaded.folder.votes()))
        return std::nullopt;
    const auto store = value_or_stop(store::open_votes(loaded.folder.votes()));
    return static_cast<int>(value_or_stop(store::screened_observers(*store)).size());
}

/// ITU-R BT.500, line by line.
void say_conformity(const LoadedStudy& loaded) {
    fmt::print("ITU-R BT.500:\n");
    std::map<protocols::Verdict, int> counts;
    for (const auto& line : protocols::bt500_conformity(loaded.study, {screened_so_far(loaded)})) {
        ++counts[line.verdict];
        fmt::print("  {:<31} {}: {}\n", protocols::words_of(line.verdict), line.asked,
                   line.because);
    }
    fmt::print("  {} met, {} not met, {} only the experimenter can know\n",
               counts[protocols::Verdict::Met], counts[protocols::Verdict::NotMet],
               counts[protocols::Verdict::OnlyTheExperimenterKnows]);
}

void say_how_long(const Study& study) {
    const auto length = protocols::estimated_length(study);
    const auto minutes = static_cast<double>(length.count()) / 60.0;
    fmt::print("length: about {:.0f} minutes a sitting{}\n", minutes,
               length > protocols::longest_session ? " - WARNING: BT.500 asks for at most 30" : "");
}

void say_which_order(const Study& study) {
    for (int session = 1; session <= study.plan.sessions; ++session)
        value_or_stop(protocols::make_schedule(study, {"check"}, session));
    const auto schedule = value_or_stop(protocols::make_schedule(study, {"check"}, 1));
    fmt::print("order: {}\n", schedule.scene_rule);
}

void check_models(const LoadedStudy& loaded, const Voice& voice) {
    for (const auto& scene : loaded.study.scenes) {
        auto model = load_model(scene, loaded.folder);
        if (!model)
            throw CommandError(fmt::format("{}:{}: scene \"{}\": {}",
                                           loaded.folder.study_file().string(), scene.line,
                                           scene.id.value, model.error()));
        fmt::print("scene {}: {} vertices, {} triangles, from {}\n", scene.id.value,
                   model->record.vertices, model->record.triangles, model->record.file);
        for (const auto& remark : model->remarks)
            voice.remark("  " + remark);
    }
}

/// Before the first rendering nothing is there; afterwards everything has to be as the study asks.
void check_pictures(const LoadedStudy& loaded) {
    if (has_rendered_conditions(loaded.study) &&
        !std::filesystem::exists(loaded.folder.manifest())) {
        fmt::print("stimuli: still to render, `pairlight render {}`\n",
                   loaded.folder.root.string());
        return;
    }
    value_or_stop(stimuli::check_stimuli(loaded));
    fmt::print("stimuli: all there, as the study asks\n");
}

} // namespace

void add_check(Command& program) {
    struct Options {
        std::string study;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto command = program.add_command("check", "Whether a study can be run as it stands");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    add_voice(command, options->voice);
    command.runs([options] {
        const auto loaded = value_or_stop(read_study(options->study));
        say_what_is_asked(loaded.study);
        value_or_stop(read_instructions(loaded));
        say_how_long(loaded.study);
        say_which_order(loaded.study);
        if (has_rendered_conditions(loaded.study))
            check_models(loaded, options->voice);
        check_pictures(loaded);
        say_conformity(loaded);
        fmt::print("observers: fewer than 15 make it an informal study (BT.500)\n");
    });
}

} // namespace experiment::commands
