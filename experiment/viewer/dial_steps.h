// Turning a dial by one notch, whatever kind of dial it is.
#pragma once

#include "renderer/methods/dials.h"

namespace experiment::viewer {

/// The neighbour of `now` upward (`by` > 0) or downward.  Names stand below numbers, and go round
/// where there are only names.  Whole numbers of a range up to 64 wide move by one, of a wider one
/// by a factor of two; other numbers by a twentieth of their range, or by a quarter of themselves
/// where the range is more than ten times the preset.  A dial at its end stays.
renderer::methods::DialValue
stepped(const renderer::methods::Dial& dial, const renderer::methods::DialValue& now, int by);

} // namespace experiment::viewer
