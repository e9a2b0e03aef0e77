// Under which circumstances votes were given: display and room, observers, sessions as held.
#pragma once

#include "experiment/report/facts.h"

namespace experiment::report {

FactList about_the_display(const Records& records);
FactList about_the_observers(const Records& records, const analysis::Findings& findings);
FactList about_the_sessions(const Records& records);

} // namespace experiment::report
