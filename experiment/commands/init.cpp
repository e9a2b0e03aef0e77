// pairlight init: a new study folder, commented, ready to run.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/study_folder.h"
#include "experiment/text_files.h"
#include "protocols/studies/instructions.de.md.h"
#include "protocols/studies/instructions.md.h"
#include "protocols/studies/own-images.toml.h"
#include "protocols/studies/quick.toml.h"
#include "protocols/studies/shss-2012.toml.h"

#include <fmt/core.h>

#include <map>
#include <memory>
#include <string_view>

namespace experiment::commands {

namespace fs = std::filesystem;

namespace {

const std::map<std::string, std::string_view>& study_templates() {
    static const std::map<std::string, std::string_view> texts{
        {"shss-2012", templates::shss_2012_toml},
        {"own-images", templates::own_images_toml},
        {"quick", templates::quick_toml}};
    return texts;
}

/// The template in another language: its instructions, its question, and what its pages speak.
std::string in_german(std::string text) {
    const auto replace = [&](std::string_view english, std::string_view german) {
        for (auto at = text.find(english); at != std::string::npos;
             at = text.find(english, at + german.size()))
            text.replace(at, english.size(), german);
    };
    replace("language = \"en\"", "language = \"de\"");
    replace("\"Which picture looks more realistic?\"", "\"Welches Bild wirkt realistischer?\"");
    return text;
}

} // namespace

void make_study_folder(const fs::path& path,
                       const std::string& template_name,
                       const std::string& language) {
    const StudyFolder folder{path};
    if (fs::exists(folder.study_file()))
        throw CommandError(fmt::format("{}: there is a study already; choose another folder",
                                       folder.study_file().string()));
    if (fs::exists(folder.root / "instructions.md"))
        throw CommandError(
            fmt::format("{}: is there already and would be written over; move it away",
                        (folder.root / "instructions.md").string()));
    const std::string study(study_templates().at(template_name));
    const bool german = language == "de";
    value_or_stop(
        write_text_file(folder.root / "instructions.md",
                        german ? templates::instructions_de_md : templates::instructions_md));
    value_or_stop(write_text_file(folder.study_file(), german ? in_german(study) : study));
}

void add_init(Command& program) {
    struct Options {
        std::string folder;
        std::string study_template = "quick";
        std::string language = "en";
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto command = program.add_command("init", "Make a new study folder, commented, ready to run");
    command.add_option("DIR", options->folder, "The new folder").required().not_standard_output();
    command.add_option("--template", options->study_template, "The study to begin with")
        .one_of({"shss-2012", "own-images", "quick"})
        .shows_default();
    command.add_option("--language", options->language, "Of the instructions and the pages")
        .one_of({"en", "de"})
        .shows_default();
    add_voice(command, options->voice);
    command.runs([options] {
        make_study_folder(options->folder, options->study_template, options->language);
        fmt::print("{}\n", StudyFolder{options->folder}.study_file().string());
        options->voice.remark(fmt::format(
            "Next: edit it{1}, then `pairlight check {0}` and `pairlight render {0}`.",
            options->folder,
            options->study_template == "own-images"
                ? fmt::format(" and put the pictures where it says (or let `pairlight import {} "
                              "--from DIR` do that)",
                              options->folder)
                : ""));
    });
}

} // namespace experiment::commands
