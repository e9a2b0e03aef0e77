// What `pairlight cost` found, as a table for other programs and as JSON to be read again.
#pragma once

#include "experiment/cost/cost_report.h"

#include <tl/expected.hpp>

#include <string>
#include <string_view>

namespace experiment::cost {

/// A row for every scene, light and setting; empty fields for what was not measured.
std::string cost_csv(const CostReport& report);

std::string cost_json(const CostReport& report);

/// Errors: "<file_name>: <what is wrong>".
tl::expected<CostReport, std::string> parse_cost(std::string_view text, std::string_view file_name);

} // namespace experiment::cost
