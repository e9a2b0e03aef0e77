// The trials of one sitting: what is asked, in which order, on which sides.
// Order: uniform over all orders without equal neighbours.  Sides: Euler circuits.
#pragma once

#include "protocols/expected.h"
#include "protocols/study.h"

#include <optional>
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
    std::string generator;    ///< name of the random number generator
    std::string order_seed;   ///< hexadecimal; enough to draw the order again
    std::string sides_seed;   ///< of a session that mirrors another's sides: that one's
    int equal_neighbours = 0; ///< main neighbours that share a scene: 0, or the unavoidable minimum
    std::string
        scene_rule; ///< "no two neighbours share a scene" or what had to be given up, in words
};

/// Draws the sitting number `session` (1-based) of `observer`.  Same arguments, same schedule, on
/// every machine.
///
/// Main: all pairs at all pictures, `repetitions` times; neighbours of different scenes; a question
/// asked again not within 3 trials; every condition as often left as right (to one), in each scene
/// and overall.  Different sessions of one observer get different orders; an even session mirrors
/// the sides of the one before it.  With a `partner`, every session mirrors the sides of that
/// observer's session of the same number: between the two of them, each question has been asked as
/// often one way round as the other.
/// Warm-ups: questions of the main part, none of its first 3, the last of another scene than its
/// first.  Training: questions of the main part, the easy and the hard pair among them.  Where a
/// small study permits less, `scene_rule` says so. Errors: a session number
/// outside 1..plan.sessions; a study without pairs; a nameless observer.
Expected<Schedule> make_schedule(const Study& study,
                                 const ObserverId& observer,
                                 int session,
                                 const std::optional<ObserverId>& partner = {});

} // namespace protocols
