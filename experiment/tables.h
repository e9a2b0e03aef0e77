// Tables as CSV text (RFC 4180), in the forms that scripts rely on.
#pragma once

#include "protocols/schedule.h"

#include <string>
#include <vector>

namespace experiment {

/// Fields joined by commas, with the line's end.
std::string csv_row(const std::vector<std::string>& fields);

/// `trial,phase,scene,variant,left,right`, phase training|warmup|main.
std::string schedule_csv(const protocols::Schedule& schedule);

} // namespace experiment
