// The program's table of contents.
#include "experiment/commands/command.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cstdlib>

int main(int argc, char** argv) {
    CLI::App program("Pairlight: which rendering do people find more realistic, by how much, and "
                     "how sure is that?",
                     "pairlight");
    program.require_subcommand(1);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error);
    } catch (const std::exception& error) {
        fmt::print(stderr, "pairlight: {}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
