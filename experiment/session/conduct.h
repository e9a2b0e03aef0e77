// A sitting from its first page to its last, between a screen, a clock and the vote store.
#pragma once

#include "experiment/session/clock.h"
#include "experiment/session/screen.h"
#include "experiment/session/sitting.h"
#include "experiment/store/vote_store.h"
#include "protocols/schedule.h"
#include "protocols/study.h"

#include <functional>
#include <optional>
#include <string>

namespace experiment::session {

/// Which sitting, and all that is written down about it beforehand.
struct SittingRequest {
    protocols::Study study;
    std::string study_sha256;
    store::SittingKey key;
    protocols::Schedule schedule; ///< of this sitting
    std::string instructions;     ///< the file's text
    std::string renderer;         ///< what drew the pictures
    /// A simulated observer, written out in full (`text_of`); empty for a person.
    std::optional<std::string> simulation;
    /// Why a sitting may come sooner than the study's `days_apart` allows.
    std::optional<std::string> override_reason;
    /// Told after every step how far the sitting has come.
    std::function<void(const Standing&)> watch{};
    /// Of the pictures' files, hexadecimal; recorded with the sitting.  Empty: not known.
    std::string stimuli_sha256{};
};

struct SittingOutcome {
    bool resumed = false;
    bool finished = false; ///< false: stopped on request, to be resumed
    int votes = 0;         ///< of the whole sitting, now in the store
};

/// Says whether the sitting may take place now, without writing anything.
/// Errors: it is finished; it was begun with another plan, or simulated where it would now be a
/// person's (or the other way round); the observer's other sittings are too near, or lie in the
/// future by this clock; a person of whom the study's questions are not answered, or who has not
/// consented; no page of instructions.
Expected<void>
check_sitting(const SittingRequest& request, const store::VoteStore& store, const Clock& clock);

/// How a study's built-in pages speak.
PageStyle page_style(const protocols::Study& study);

/// Conducts it.  Every showing is recorded while it is on the screen, every vote before the next
/// view.  A sitting that was begun before goes on: instructions, questions, adaptation and warm-ups
/// are shown again (training only after more than half an hour), votes stand.
/// Errors: those of check_sitting, of the store and of the screen; what was recorded stands.
Expected<SittingOutcome>
conduct(const SittingRequest& request, store::VoteStore& store, Screen& screen, const Clock& clock);

} // namespace experiment::session
