// Whether votes put their conditions on one finite scale.  [Ford1957]
#pragma once

#include "analysis/scaling/counts.h"

#include <vector>

namespace analysis::scaling {

enum class Scale {
    Finite,    ///< everybody beats everybody through a chain of wins: one finite scale
    Separated, ///< compared with each other, but some never lose to the rest: infinitely far apart
    Disconnected ///< some were never compared with the rest, not even through others
};

/// Sets of conditions (indices rising).  `components` splits them where the scale breaks: for
/// Separated the strong components, those that dominate before those they dominate; for
/// Disconnected the groups that were compared with each other.  One component when Finite.
struct Existence {
    Scale scale = Scale::Finite;
    std::vector<std::vector<std::size_t>> components;
};

/// Whether the maximum-likelihood scores of a choice model with these wins are finite: exactly when
/// the directed graph "i was chosen over j at least once" is strongly connected.
Existence existence(const WinCounts& counts);

} // namespace analysis::scaling
