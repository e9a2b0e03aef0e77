// Where the two pictures of a pair lie on the screen.
#include "experiment/session/pair_layout.h"

#include <fmt/format.h>

namespace experiment::session {

protocols::Expected<PairLayout>
lay_out_pair(int screen_width, int screen_height, int width, int height, int gap) {
    const int needed = 2 * width + gap;
    if (needed > screen_width || height > screen_height)
        return tl::unexpected(fmt::format(
            "two pictures of {} x {} pixels and a gap of {} need {} x {} pixels, but the screen "
            "has {} x {}; expected smaller pictures or a larger screen (pictures are never scaled)",
            width, height, gap, needed, height, screen_width, screen_height));
    const int left = (screen_width - needed) / 2;
    return PairLayout{left, left + width + gap, (screen_height - height) / 2, width, height};
}

} // namespace experiment::session
