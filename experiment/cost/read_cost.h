// What an earlier `pairlight cost` has written, read again.
#pragma once

#include "experiment/cost/cost_report.h"

#include <tl/expected.hpp>

#include <string>
#include <string_view>

namespace experiment::cost {

/// Errors: "<file_name>:<line>: <what is wrong>; <remedy>", for anything that `cost_json` does not
/// write: missing and foreign values, numbers that nothing measures, a picture that is there twice,
/// names that could not be those of files.
tl::expected<CostReport, std::string> parse_cost(std::string_view text, std::string_view file_name);

} // namespace experiment::cost
