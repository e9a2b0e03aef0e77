// Where the two pictures of a pair lie on the screen.
#include "experiment/session/pair_layout.h"

#include <fmt/format.h>

namespace experiment::session {

namespace {

int count_of(Places places) {
    return places == Places::One ? 1 : places == Places::Three ? 3 : 2;
}

} // namespace

protocols::Expected<PairLayout>
lay_out_pair(int screen_width, int screen_height, int width, int height, int gap, Places places) {
    const int count = count_of(places);
    const int needed = count * width + (count - 1) * gap;
    if (needed > screen_width || height > screen_height)
        return tl::unexpected(fmt::format(
            "{} pictures of {} x {} pixels and a gap of {} need {} x {} pixels, but the screen "
            "has {} x {}; expected smaller pictures or a larger screen (pictures are never scaled)",
            count == 1   ? "single"
            : count == 2 ? "two"
                         : "three",
            width, height, gap, needed, height, screen_width, screen_height));
    const int first = (screen_width - needed) / 2;
    const int step = width + gap;
    const int top = (screen_height - height) / 2;
    switch (places) {
    case Places::Two:
        return PairLayout{first, first + step, top, width, height};
    case Places::Three:
        return PairLayout{first, first + 2 * step, top, width, height, first + step};
    case Places::One:
        return PairLayout{first, first, top, width, height};
    case Places::OneAndReference:
        break;
    }
    return PairLayout{first + step, first + step, top, width, height, first};
}

} // namespace experiment::session
