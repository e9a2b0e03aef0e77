// The program's table of contents.
#include "experiment/commands/command.h"
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace commands = experiment::commands;

int main(int argc, char** argv) {
    CLI::App program("Pairlight: which rendering do people find more realistic, by how much, and "
                     "how sure is that?",
                     "pairlight");
    program.require_subcommand(1);
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
        commands::expect_command(program, {argv, static_cast<std::size_t>(argc)});
        commands::expect_values(program, {argv, static_cast<std::size_t>(argc)});
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return program.exit(help);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "pairlight: {}\n", commands::complaint_of(program, error));
        return error.get_exit_code();
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
