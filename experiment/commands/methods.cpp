// pairlight methods: every shading method and its dials, as a study file may name them.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/reference_dials.h"
#include "renderer/methods/catalogue.h"

#include <fmt/core.h>

#include <memory>
#include <string>
#include <vector>

namespace experiment::commands {

namespace {

using renderer::methods::Description;
using renderer::methods::Dial;
using renderer::methods::text_of;

std::string values_of(const Dial& dial) {
    std::string values;
    const auto add = [&](const std::string& more) {
        values += values.empty() ? more : ", " + more;
    };
    if (dial.whole)
        add(fmt::format("{} to {}, whole", dial.whole->least, dial.whole->most));
    if (dial.number)
        add(fmt::format("{} to {}", dial.number->least, dial.number->most));
    for (const auto& name : dial.names)
        add(fmt::format("\"{}\"", name));
    return values;
}

std::string as_text(const Description& method) {
    auto text = fmt::format("{}: {}{}\n", method.name, method.label,
                            method.source.empty() ? "" : fmt::format(" [{}]", method.source));
    for (const auto& dial : method.dials)
        text += fmt::format("    {} = {} ({}): {}\n", dial.name, text_of(dial.preset),
                            values_of(dial), dial.meaning);
    return text;
}

std::string as_markdown(const Description& method) {
    auto text = fmt::format("\n## `{}`: {}{}\n\n", method.name, method.label,
                            method.source.empty() ? "" : fmt::format(" [{}]", method.source));
    if (method.dials.empty())
        return text + "No dials.\n";
    text += "| dial | meaning | values | preset |\n|---|---|---|---|\n";
    for (const auto& dial : method.dials)
        text += fmt::format("| `{}` | {} | {} | {} |\n", dial.name, dial.meaning, values_of(dial),
                            text_of(dial.preset));
    return text;
}

/// Those that draw, and the one that follows light.
std::vector<Description> all_methods() {
    const auto drawn = renderer::methods::catalogue();
    std::vector<Description> all(drawn.begin(), drawn.end());
    all.push_back({.name = std::string(reference_method),
                   .label = "Path-traced reference",
                   .dials = reference_dials()});
    return all;
}

} // namespace

void add_methods(Command& program) {
    const auto markdown = std::make_shared<bool>(false);
    auto command = program.add_command(
        "methods", "The shading methods and their dials, as a study file may name them");
    command.add_flag("--markdown", *markdown, "As the page docs/methods.md");
    command.runs([markdown] {
        if (*markdown)
            fmt::print("# Methods\n\nWhat `method` and its dials may be in a `[[condition]]`. Keys "
                       "in brackets are those of [bibliography.md](bibliography.md). This page is "
                       "the output of `pairlight methods --markdown`.\n");
        for (const auto& method : all_methods())
            fmt::print("{}", *markdown ? as_markdown(method) : as_text(method));
    });
}

} // namespace experiment::commands
