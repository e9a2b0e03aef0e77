// What `pairlight cost` found, as a table for other programs and as JSON to be read again.
#pragma once

#include "experiment/cost/cost_report.h"

#include <string>

namespace experiment::cost {

/// Of `cost_json`.  2: every row has its own mesh.
inline constexpr int form_version = 2;

/// A row for every scene, light and setting; empty fields for what was not measured.
std::string cost_csv(const CostReport& report);

/// All there is; read again by read_cost.h.
std::string cost_json(const CostReport& report);

} // namespace experiment::cost
