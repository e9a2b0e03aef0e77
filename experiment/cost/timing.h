// What a frame of every setting takes, drawn in turns.
#pragma once

#include "experiment/cost/preparation.h"

#include <tl/expected.hpp>

#include <span>
#include <string>

namespace experiment::cost {

/// Fills times and bytes of the rows, one for each contestant in their order.
/// Errors: OpenGL's own.
tl::expected<void, std::string> time_frames(const SceneCase& measured,
                                            const Prepared& prepared,
                                            std::span<Row> rows,
                                            const Reporting& report);

} // namespace experiment::cost
