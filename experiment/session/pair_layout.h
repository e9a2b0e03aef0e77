// Where the two pictures of a pair lie on the screen.
#pragma once

#include "protocols/expected.h"

namespace experiment::session {

/// How many pictures are on the screen at once, and in which places.
enum class Places {
    Two,            ///< left and right
    Three,          ///< left, the reference in the middle, right
    One,            ///< in the middle, one after the other
    OneAndReference ///< the reference left, and the others in turn right of it
};

struct PairLayout {
    int left_x = 0;  ///< left edge of the left picture, pixels from the left
    int right_x = 0; ///< left edge of the right picture
    int top = 0;     ///< upper edge of both, pixels from the top
    int width = 0;   ///< of each picture
    int height = 0;
    int reference_x = 0; ///< left edge of the reference, where there is one
    bool operator==(const PairLayout&) const = default;
};

/// Side by side, native pixels, one centre line, equal margins (to one pixel).  Pictures that come
/// in turn have the same place.
/// Errors: pictures that do not fit; nothing is ever scaled.
protocols::Expected<PairLayout> lay_out_pair(int screen_width,
                                             int screen_height,
                                             int width,
                                             int height,
                                             int gap,
                                             Places places = Places::Two);

} // namespace experiment::session
