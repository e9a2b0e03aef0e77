// pairlight register: an observer before the first sitting, by a pseudonym and nothing that names
// anybody.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/sittings.h"
#include "experiment/session/clock.h"
#include "experiment/store/screened.h"
#include "experiment/vote_source.h"
#include "protocols/digest.h"
#include "protocols/questionnaire.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <random>

namespace experiment::commands {

namespace {

using protocols::ObserverId;
using protocols::ObserverQuestion;

struct Options {
    std::string study;
    std::optional<std::string> observer; ///< without one, a pseudonym is drawn
    bool consent = false;
    std::vector<std::string> answers;
    Voice voice;
};

/// "P" and four letters or digits that nobody confuses, such as none of the observers has.
ObserverId new_pseudonym(const std::vector<ObserverId>& taken) {
    constexpr std::string_view letters = "ABCDEFGHJKLMNPQRSTUVWXYZ23456789"; // no I, O, 0, 1
    std::random_device chance;
    while (true) {
        std::string name = "P";
        while (name.size() < 5)
            name += letters[chance() % letters.size()];
        if (std::find(taken.begin(), taken.end(), ObserverId{name}) == taken.end())
            return {name};
    }
}

std::map<std::string, std::string> given_answers(const Options& options,
                                                 const protocols::Panel& panel) {
    if (panel.questions.empty() && !options.answers.empty())
        throw CommandError(fmt::format("--answer {}: {} asks its observers nothing, expected no "
                                       "--answer, or [observer] or [[question]] in its study.toml",
                                       options.answers.front(), options.study));
    std::map<std::string, std::string> given;
    for (const auto& text : options.answers) {
        const auto equals = text.find('=');
        const auto id = text.substr(0, equals);
        const auto known = std::any_of(panel.questions.begin(), panel.questions.end(),
                                       [&](const auto& question) { return question.id == id; });
        if (equals == std::string::npos || !known) {
            std::vector<std::string> ids;
            for (const auto& question : panel.questions)
                ids.push_back(question.id);
            throw CommandError(fmt::format("--answer {}: expected QUESTION=ANSWER for one of {}",
                                           text, fmt::join(ids, ", ")));
        }
        if (!given.emplace(id, text.substr(equals + 1)).second)
            throw CommandError(fmt::format("--answer {}: question \"{}\" has the answer \"{}\" "
                                           "already, expected one for each question",
                                           text, id, given.at(id)));
    }
    return given;
}

std::string prompt_of(const ObserverQuestion& question) {
    return question.kind == ObserverQuestion::Kind::Choice
               ? fmt::format("{} ({}): ", question.ask, fmt::join(question.choices, ", "))
               : fmt::format("{} ({} to {}): ", question.ask, question.least, question.greatest);
}

/// The answer that was given, or asked for on a terminal until it is one.
std::string answer_to(const ObserverQuestion& question,
                      const std::map<std::string, std::string>& given) {
    if (const auto found = given.find(question.id); found != given.end())
        return value_or_stop(checked_answer(question, found->second));
    if (isatty(STDIN_FILENO) != 1)
        throw CommandError(fmt::format("question \"{0}\" ({1}) has no answer; expected --answer "
                                       "{0}=..., or a terminal to ask on",
                                       question.id, question.ask));
    for (std::string line;;) {
        fmt::print(stderr, "{}", prompt_of(question));
        if (!std::getline(std::cin, line))
            throw CommandError("the registration was broken off; nothing was changed");
        if (auto answer = checked_answer(question, line))
            return *answer;
    }
}

void expect_consent(const Options& options, const protocols::Panel& panel) {
    if (!panel.consent || options.consent)
        return;
    throw CommandError("no session without consent; expected --consent once the observer has "
                       "read the instructions and agreed");
}

void run(const Options& options) {
    const auto loaded = value_or_stop(read_study(options.study));
    const auto& panel = loaded.study.panel;
    if (options.observer && !store::is_pseudonym(*options.observer))
        throw CommandError(fmt::format("observer \"{}\": expected a pseudonym of 1 to 32 letters, "
                                       "digits, '-' and '_'",
                                       *options.observer));
    expect_consent(options, panel);
    const auto given = given_answers(options, panel);
    std::map<std::string, std::string> answers;
    for (const auto& question : panel.questions)
        answers[question.id] = answer_to(question, given);

    const auto utc = session::utc_text(session::SystemClock().wall());
    std::vector<store::Answer> record;
    if (options.consent)
        record.push_back(
            {"consent",
             "yes, to the instructions with SHA-256 " +
                 protocols::sha256_hexadecimal(value_or_stop(read_instructions(loaded))),
             utc});
    for (const auto& question : panel.questions)
        record.push_back({question.id, answers.at(question.id), utc});
    const auto verdict = protocols::screening(panel.questions, answers);
    if (!panel.questions.empty())
        record.push_back({"screening", verdict, utc});

    const auto store = writable_store(loaded);
    const auto observer = options.observer ? ObserverId{*options.observer}
                                           : new_pseudonym(value_or_stop(store->observers()));
    value_or_stop(store->add_observer(observer, utc));
    value_or_stop(store->take_place(observer, store::ObserverKind::Person, utc));
    value_or_stop(store->append_answers(observer, record));
    fmt::print("{}: registered{}\n", observer.value,
               panel.questions.empty() ? "" : "; screening " + verdict);
    if (verdict != "passed")
        options.voice.remark("A session is possible all the same; analyses can leave the observer "
                             "out.");
}

} // namespace

void add_register(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "register",
        "An observer before the first sitting: consent, screening, the study's questions");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    command
        .add_option("--observer", options->observer,
                    "The observer's pseudonym, never a name; without it, one is drawn")
        .not_blank("a pseudonym, or no --observer to draw one");
    command.add_flag("--consent", options->consent,
                     "The observer has read the instructions and agreed to take part");
    command.add_option("--answer", options->answers,
                       "QUESTION=ANSWER, once for each question; what is missing is asked for");
    add_voice(command, options->voice);
    command.runs([options] { run(*options); });
}

void add_observers(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command("observers", "Who takes part, and how far they are");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    add_voice(command, options->voice);
    command.runs([options] {
        const auto loaded = value_or_stop(read_study(options->study));
        const auto store = value_or_stop(open_whole_votes(loaded.folder));
        const auto sittings = value_or_stop(store->sittings());
        for (const auto& observer : value_or_stop(store->observers())) {
            std::string screening = "not recorded";
            for (const auto& answer : value_or_stop(store->answers(observer)))
                if (answer.question == "screening")
                    screening = answer.answer;
            int finished = 0;
            bool simulated = false;
            for (const auto& sitting : sittings)
                if (sitting.key.observer == observer) {
                    finished += sitting.finished_utc ? 1 : 0;
                    simulated = simulated || sitting.simulation;
                }
            fmt::print("{}{}: {} of {} sittings finished; screening {}\n", observer.value,
                       simulated ? " (SIMULATED)" : "", finished, loaded.study.plan.sessions,
                       screening);
        }
        const auto screened = value_or_stop(store::screened_observers(*store)).size();
        fmt::print("{} screened with a finished sitting{}\n", screened,
                   screened < store::formal_observers
                       ? fmt::format(": an informal study (fewer than {} observers)",
                                     store::formal_observers)
                       : "");
        for (const auto& tombstone : value_or_stop(store->tombstones()))
            fmt::print("withdrawn on {}: {} rows, {} votes; {}\n", tombstone.utc.substr(0, 10),
                       tombstone.rows, tombstone.votes, tombstone.reason);
    });
}

} // namespace experiment::commands
