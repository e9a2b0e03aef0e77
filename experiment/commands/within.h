// A range for options that numbers have to lie in: unlike CLI11's own, NaN does not.
#pragma once

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>

namespace experiment::commands {

/// Both ends belong to it.
class Within : public CLI::Validator {
  public:
    Within(double least, double most) : Validator(fmt::format("[{} - {}]", least, most)) {
        func_ = [least, most](const std::string& input) {
            double value = 0;
            if (CLI::detail::lexical_cast(input, value) && value >= least && value <= most)
                return std::string();
            return fmt::format("{} is not a number from {} to {}", input, least, most);
        };
    }
};

} // namespace experiment::commands
