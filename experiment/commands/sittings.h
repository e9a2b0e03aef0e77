// Sittings as commands begin them: before a window, or by simulated observers.
#pragma once

#include "experiment/commands/command.h"
#include "experiment/read_study.h"
#include "experiment/session/conduct.h"
#include "experiment/session/window.h"
#include "protocols/vocabulary.h"

#include <optional>
#include <string>

namespace experiment::commands {

/// Everything a sitting needs to know, read from the study.  Errors: CommandError.
session::SittingRequest sitting_request(const LoadedStudy& loaded,
                                        const protocols::ObserverId& observer,
                                        int session,
                                        std::optional<std::string> simulation,
                                        std::optional<std::string> override_reason);

/// The observer's first sitting that is not finished, counted from 1.
/// Errors: CommandError when all of them are.
int next_session(const LoadedStudy& loaded, const protocols::ObserverId& observer);

/// How a person sits: on which monitor or in a window of which size.
struct SeatOptions {
    std::optional<session::WindowSize> size; ///< of a window; without it, the full screen
    int monitor = 1;                         ///< 1 is the primary one
    std::optional<std::string> override_reason;
};

/// One sitting of a person before a window.  Errors: CommandError; what was recorded stands.
session::SittingOutcome sit(const LoadedStudy& loaded,
                            const protocols::ObserverId& observer,
                            int session,
                            const SeatOptions& options,
                            const Voice& voice);

/// One sitting of a simulated observer, without a window and in virtual time: `days_later` than
/// today.
session::SittingOutcome simulate_sitting(const LoadedStudy& loaded,
                                         const protocols::ObserverId& observer,
                                         int session,
                                         const std::string& specification,
                                         int days_later);

/// All sittings of observers sim-01, sim-02, ...; those that are finished already are passed over.
void simulate_observers(const LoadedStudy& loaded,
                        int observers,
                        const std::string& specification,
                        const Voice& voice);

} // namespace experiment::commands
