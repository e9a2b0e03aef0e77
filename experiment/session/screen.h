// Where the world enters a sitting: something that shows views and reports what is done about them.
#pragma once

#include "experiment/session/inputs.h"
#include "experiment/session/timing.h"
#include "experiment/session/views.h"
#include "protocols/expected.h"

#include <optional>
#include <string>
#include <vector>

namespace experiment::session {

using protocols::Expected;

/// What a sitting's votes were seen on.
struct DisplayFacts {
    std::string description;            ///< "name=value; name=value"
    DisplayTiming timing;               ///< as tested before the sitting
    Monotonic refresh{};                ///< of a screen that keeps time; 0 where none is known
    std::vector<PageView> setting_up{}; ///< pages for the experimenter, before all others
};

class Screen {
  public:
    virtual ~Screen() = default;

    virtual DisplayFacts facts() const = 0;

    /// Begins to make a pair ready, without waiting for it.  Asking again costs nothing.
    virtual void prepare(const PairView& pair) = 0;

    /// Shows a view and returns when it is visible; the input says since when (what it is matters
    /// for pairs only, and is OnsetSeen).  Both pictures of a pair appear at once.
    /// Errors: a picture that cannot be loaded or has another size than the study says.
    virtual Expected<Input> show(const View& view) = 0;

    /// The next thing that happens, or nothing when `until` has come first.
    virtual std::optional<Input> wait(std::optional<Monotonic> until) = 0;
};

} // namespace experiment::session
