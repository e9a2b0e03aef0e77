// The trials of one sitting: what is asked, in which order, on which sides.
// Order: uniform over all orders without equal neighbours.  Sides: Euler circuits.
#pragma once

#include "protocols/expected.h"
#include "protocols/study.h"

#include <string>
#include <vector>

namespace protocols {

struct PlannedTrial {
    int number = 0; ///< 1.. over the whole sitting: training, then warm-ups, then main
    Phase phase{};
    Trial trial;
};

struct Schedule {
    std::vector<PlannedTrial> trials;
    std::string generator;  ///< name of the random number generator
    std::string order_seed; ///< hexadecimal; enough to draw the order again
    std::string sides_seed;
    int equal_neighbours = 0; ///< main neighbours that share a scene: 0, or the unavoidable minimum
    std::string
        scene_rule; ///< "no two neighbours share a scene" or what had to be given up, in words
};

/// Draws the sitting number `session` (1-based) of `observer`.  Same arguments, same schedule, on
/// every machine. Different sessions of one observer get different orders; session 2 mirrors the
/// sides of session 1. Errors: a session number outside 1..plan.sessions; a study without pairs.
Expected<Schedule> make_schedule(const Study& study, const ObserverId& observer, int session);

} // namespace protocols
