// Simulated observers: people whose taste is known, to try studies and analyses on.
// Model: [Thurstone1927], Case V.
#pragma once

#include "experiment/session/inputs.h"
#include "protocols/expected.h"
#include "protocols/random.h"
#include "protocols/study.h"

#include <chrono>
#include <map>
#include <string>
#include <string_view>

namespace experiment::session {

using protocols::Expected;

/// Sees each picture with its condition's true score plus normal noise, and chooses the greater
/// impression.  So P(left) = Phi((left - right + side_bias) / (noise sqrt 2)), but for lapses.
struct SimulatedObserver {
    std::map<protocols::ConditionId, double> scores; ///< in any unit, that of `noise`
    double noise = 1;                                ///< standard deviation of one impression, > 0
    double side_bias = 0; ///< added to the impression of the left picture
    double lapse = 0;     ///< share of answers given without looking, 0..1
    std::uint64_t seed = 1;
};

struct SimulatedAnswer {
    protocols::Side side{};
    std::chrono::nanoseconds response_time{}; ///< above 400 ms, mostly 1 to 3 s
    double preference = 0; ///< for the right picture, in standard deviations of one impression
};

/// The key for an answer.  Where there is a way to say so, the two look alike to a simulated
/// observer below a preference of 0.25; "slightly" ends at 0.75, "much" begins at 1.5.  A lapse is
/// answered slightly.
Key key_of(const SimulatedAnswer& answer, protocols::Response response);

/// Reads "scores=shss-25:1.0,green:0.2;noise=1;bias=0;lapse=0.02;seed=7", every part optional.
/// Without scores, the study's conditions lie between 1 (its first) and 0 (its last), evenly.
/// Errors: unknown parts, unknown or missing conditions, numbers out of range; the message quotes
/// the text.
Expected<SimulatedObserver> parse_simulated_observer(std::string_view text,
                                                     const protocols::Study& study);

/// The observer written out in full; reading it gives the same observer.
std::string text_of(const SimulatedObserver& observer);

/// The answer to one trial.  It depends on the arguments only: an interrupted sitting that is taken
/// up again has the answers it would have had.
SimulatedAnswer answer(const SimulatedObserver& observer,
                       const std::string& study,
                       const protocols::ObserverId& name,
                       int session,
                       int trial_number,
                       const protocols::Trial& trial);

} // namespace experiment::session
