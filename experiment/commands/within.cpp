// Numbers are compared so that NaN fails.
#include "experiment/commands/within.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>

namespace experiment::commands {

CLI::Validator within(double least, double most) {
    const auto refuse = [least, most](const std::string& input) {
        double value = 0;
        if (CLI::detail::lexical_cast(input, value) && value >= least && value <= most)
            return std::string();
        return fmt::format("{} is not a number from {} to {}", input, least, most);
    };
    return CLI::Validator(refuse, fmt::format("[{} - {}]", least, most));
}

CLI::Validator not_blank(const char* wanted) {
    return CLI::Validator(
        [wanted](const std::string& input) {
            return input.find_first_not_of(" \t\r\n") == std::string::npos
                       ? fmt::format("\"{}\" says nothing, expected {}", input, wanted)
                       : std::string();
        },
        "");
}

} // namespace experiment::commands
