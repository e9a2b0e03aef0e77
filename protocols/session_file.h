// The tables of a study file that say how people are asked: [display], [room], [session], [keys],
// [instructions], [observer] and [[question]].
#pragma once

#include "protocols/section.h"
#include "protocols/study.h"

namespace protocols {

/// Reads them from the outermost table; what is missing keeps its default.
void read_session_tables(Section& file, Study& study);

/// Notes a reference that is no condition of the study, and practised pairs that are never
/// compared. Once the conditions are read.
void expect_known_conditions(Section& file, const Study& study);

} // namespace protocols
