// The program's table of contents.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace commands = experiment::commands;

int main(int argc, char** argv) {
    commands::CommandLine line("pairlight",
                               "Pairlight: which rendering do people find more "
                               "realistic, by how much, and how sure is that?",
                               PAIRLIGHT_PROGRAM_VERSION);
    auto program = line.program();
    // clang-format off
    for (const auto add : {
             commands::add_init,
             commands::add_check,
             commands::add_methods,
             commands::add_view,
             commands::add_render,
             commands::add_import,
             commands::add_display,
             commands::add_photometer,
             commands::add_timing_check,
             commands::add_pages,
             commands::add_register,
             commands::add_observers,
             commands::add_session,
             commands::add_simulate,
             commands::add_export,
             commands::add_analyze,
             commands::add_anova,
             commands::add_report,
             commands::add_demo,
             commands::add_schedule,
             commands::add_thickness,
             commands::add_simplify,
             commands::add_reference,
             commands::add_compare,
             commands::add_fit,
             commands::add_cost,
             commands::add_verify,
             commands::add_withdraw,
         })
        // clang-format on
        add(program);
    try {
        const int status = line.run({argv, static_cast<std::size_t>(argc)});
        if (status != EXIT_SUCCESS)
            return status;
    } catch (const std::filesystem::filesystem_error& error) {
        fmt::print(stderr, "pairlight: {}: {}; see to it that it can be read and written\n",
                   error.path1().string(), error.code().message());
        return EXIT_FAILURE;
    } catch (const std::exception& error) {
        fmt::print(stderr, "pairlight: {}\n", error.what());
        return EXIT_FAILURE;
    }
    if (std::fflush(stdout) != 0) {
        fmt::print(stderr, "pairlight: the result could not be written to standard output\n");
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
