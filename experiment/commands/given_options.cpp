// The parser knows what was given.
#include "experiment/commands/given_options.h"

#include "experiment/commands/command.h"
#include "experiment/commands/within.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <map>

namespace experiment::commands {

using renderer::geometry::Holes;

bool was_given(const CLI::App& command, const char* option) {
    return command.get_option(option)->count() > 0;
}

void expect_not_given(const CLI::App& command,
                      std::initializer_list<const char*> options,
                      const std::string& why) {
    for (const auto* option : options)
        if (was_given(command, option))
            throw CommandError(fmt::format("{}: {}", option, why));
}

void expect_direction(const char* option, const std::array<double, 3>& v) {
    if (!(std::hypot(v[0], v[1], v[2]) > 0))
        throw CommandError(fmt::format("{} {} {} {}: expected a direction, not all zero", option,
                                       v[0], v[1], v[2]));
}

void add_holes(CLI::App& command, Holes& holes) {
    command
        .add_option("--holes", holes,
                    "What to do with a model's surface that is not closed: refuse it, or take for "
                    "inside where it winds more than half around")
        ->transform(word_for(numbered(std::map<std::string, Holes>{
            {"refuse", Holes::Refuse}, {"winding", Holes::ByWinding}})));
}

} // namespace experiment::commands
