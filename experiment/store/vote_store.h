// The vote store: the journal of a study.  Append-only, each write durable before it returns.
#pragma once

#include "experiment/store/records.h"
#include "protocols/expected.h"

#include <span>
#include <string>
#include <vector>

namespace experiment::store {

using protocols::Expected;

/// 1..32 letters, digits, '-' and '_': what an observer may be called.
bool is_pseudonym(const std::string& id);

/// SHA-256 over the planned trials in order, hexadecimal: the same plan, the same digest.
std::string plan_digest(std::span<const protocols::PlannedTrial> plan);

/// One store for one study.  Every error is one line that names the store and changes nothing that
/// was recorded.  A failed write was not written at all.
class VoteStore {
  public:
    virtual ~VoteStore() = default;

    /// Registers a pseudonym; nothing happens when it is there already.
    /// Errors: not 1..32 letters, digits, '-' and '_'; that of somebody who was withdrawn.
    virtual Expected<void> add_observer(const protocols::ObserverId& observer,
                                        const std::string& utc) = 0;

    /// Gives an observer the lowest place in the panel that is free among their kind; nothing
    /// happens when they have one, or have begun a sitting without.
    /// Errors: an unknown observer.
    virtual Expected<void> take_place(const protocols::ObserverId& observer,
                                      ObserverKind kind,
                                      const std::string& utc) = 0;

    /// Writes the sitting's header and its whole plan, in one transaction.
    /// Errors: an unknown observer; a sitting with this key, finished or not; a person's sitting
    /// for an observer who was simulated before, and the other way round.
    virtual Expected<void> begin_sitting(const SittingStart& start,
                                         std::span<const protocols::PlannedTrial> plan) = 0;

    /// Errors of these five: no such sitting; a finished one; for the first two, a trial that is
    /// not in the plan; for votes, a trial that is not a main trial, has not been recorded as
    /// shown, has a vote, or is on record as missing.
    virtual Expected<void> append_shown(const SittingKey& key, const Shown& shown) = 0;
    virtual Expected<void> append_vote(const SittingKey& key, const MainVote& vote) = 0;
    virtual Expected<void> append_event(const SittingKey& key, const SittingEvent& event) = 0;

    /// What the screen did while no vote came of it.
    virtual Expected<void> append_frames(const SittingKey& key, const FramesSeen& seen) = 0;

    /// What was answered about an observer; a later answer to the same question is the one that
    /// counts.  Errors: an unknown observer.
    virtual Expected<void> append_answers(const protocols::ObserverId& observer,
                                          std::span<const Answer> answers) = 0;

    /// Removes everything kept of an observer, for good, and leaves a tombstone.
    /// Errors: an unknown observer.
    virtual Expected<Tombstone> withdraw(const protocols::ObserverId& observer,
                                         const std::string& utc,
                                         const std::string& reason) = 0;

    /// Errors, too: a main trial of the plan without a vote that is not on record as missing.
    virtual Expected<void> finish_sitting(const SittingKey& key, const std::string& utc) = 0;

    /// Which study this store was made for.
    virtual Expected<StudyIdentity> study() const = 0;

    /// Every observer, in order of arrival.
    virtual Expected<std::vector<protocols::ObserverId>> observers() const = 0;

    /// Whose sides an observer's sittings mirror: in every second place of the panel, those of the
    /// observer one place before.  Somebody without one is answered as if they took it now.
    /// Empty: nobody's.
    virtual Expected<std::optional<protocols::ObserverId>>
    partner(const protocols::ObserverId& observer, ObserverKind kind) const = 0;

    /// Every sitting, in order of its beginning.
    virtual Expected<std::vector<SittingSummary>> sittings() const = 0;

    /// Everything kept of one sitting; empty when there is none.
    virtual Expected<std::optional<Sitting>> sitting(const SittingKey& key) const = 0;

    /// All votes, by observer in order of arrival, session and trial.
    virtual Expected<std::vector<VoteRow>> votes() const = 0;

    /// All answers about an observer, in the order they were given.
    virtual Expected<std::vector<Answer>> answers(const protocols::ObserverId& observer) const = 0;

    virtual Expected<std::vector<Tombstone>> tombstones() const = 0;

    /// Reads everything and says what is wrong, one line each: rows changed, missing or swapped;
    /// votes without a showing; finished sittings with main trials unanswered.  Empty when all is
    /// well.
    virtual Expected<std::vector<std::string>> verify() const = 0;
};

} // namespace experiment::store
