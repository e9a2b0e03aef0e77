// Sittings as commands begin them: before a window, or by simulated observers.
#pragma once

#include "experiment/commands/command.h"
#include "experiment/read_study.h"
#include "experiment/session/conduct.h"
#include "experiment/session/window.h"
#include "experiment/store/vote_store.h"
#include "protocols/vocabulary.h"

#include <memory>
#include <optional>
#include <string>

namespace experiment::commands {

/// Everything a sitting needs to know, read from the study.  Errors: CommandError.
session::SittingRequest sitting_request(const LoadedStudy& loaded,
                                        const protocols::ObserverId& observer,
                                        int session,
                                        std::optional<std::string> simulation,
                                        std::optional<std::string> override_reason);

/// Whose sides an observer's sittings mirror, by the study's votes: nobody's where there are none.
/// Errors: CommandError.
std::optional<protocols::ObserverId> partner_of(const LoadedStudy& loaded,
                                                const protocols::ObserverId& observer,
                                                store::ObserverKind kind);

/// The observer's first sitting that is not finished, counted from 1.
/// Errors: CommandError when all of them are.
int next_session(const LoadedStudy& loaded, const protocols::ObserverId& observer);

/// How a person sits: on which monitor or in a window of which size.
struct SeatOptions {
    std::optional<session::WindowSize> size; ///< of a window; without it, the full screen
    int monitor = 1;                         ///< 1 is the primary one
    std::optional<std::string> override_reason;
    bool setting_up = false; ///< the experimenter's display pages come first
    bool allow_long = false; ///< a plan that takes longer than the study allows
};

/// The votes of a study, to add some.  Errors: CommandError.
std::unique_ptr<store::VoteStore> writable_store(const LoadedStudy& loaded);

/// A window as the study wants it.
session::WindowOptions window_options(const LoadedStudy& loaded, const SeatOptions& seat);

/// One sitting of a person before a window.  Errors: CommandError; what was recorded stands.
session::SittingOutcome sit(const LoadedStudy& loaded,
                            const protocols::ObserverId& observer,
                            int session,
                            const SeatOptions& options,
                            const Voice& voice);

/// One sitting of a simulated observer in virtual time, `days_later` than today; shown in `window`
/// as well, if there is one.
session::SittingOutcome simulate_sitting(const LoadedStudy& loaded,
                                         const protocols::ObserverId& observer,
                                         int session,
                                         const std::string& specification,
                                         int days_later,
                                         session::Screen* window = nullptr);

/// All sittings of observers sim-01, sim-02, ...; those that are finished already are passed over.
/// With a size, they take place in a window of it.
void simulate_observers(const LoadedStudy& loaded,
                        int observers,
                        const std::string& specification,
                        const Voice& voice,
                        std::optional<session::WindowSize> window = {});

/// "1280x720" as a size; empty text is none.  Errors: CommandError.
std::optional<session::WindowSize> window_size(const std::string& text);

} // namespace experiment::commands
