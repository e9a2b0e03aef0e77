// What the vote store keeps, as values: one struct per kind of row.
#pragma once

#include "protocols/schedule.h"
#include "protocols/vocabulary.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace experiment::store {

/// Which study the votes belong to.
struct StudyIdentity {
    std::string id;
    std::string file_sha256; ///< of study.toml as it lay there, 64 hexadecimal digits
    bool operator==(const StudyIdentity&) const = default;
};

/// Who answers.  People and simulated observers have places of their own in the panel.
enum class ObserverKind { Person, Simulated };

/// Which sitting: `session` is 1-based.
struct SittingKey {
    protocols::ObserverId observer;
    int session = 1;
    bool operator==(const SittingKey&) const = default;
};

/// What is known of a sitting before its first trial.
struct SittingStart {
    SittingKey key;
    std::string study_sha256; ///< of the study file on that day
    std::string local_date;   ///< YYYY-MM-DD where the observer sits
    std::string started_utc;  ///< ISO 8601 with milliseconds and Z
    std::string generator;    ///< of random numbers, by name
    std::string order_seed;   ///< hexadecimal
    std::string sides_seed;   ///< hexadecimal
    std::string scene_rule;   ///< what the order keeps, in words
    std::string plan_sha256;  ///< of the planned trials: `plan_digest`
    std::string renderer;     ///< what drew the pictures that are shown
    std::string display;      ///< what shows them: facts as "name=value; name=value"
    std::string timing_grade; ///< A, B, C or U (unverified)
    /// The simulated observer's specification.  Empty for a person.
    std::optional<std::string> simulation;
    /// Why the least distance between two sittings was not kept.  Empty where it was.
    std::optional<std::string> override_reason;
    bool operator==(const SittingStart&) const = default;
};

/// A trial that was on the screen.
struct Shown {
    int trial = 0;             ///< its number in the plan
    int presentation = 1;      ///< 1; 2 when it is shown again after an interruption, ...
    std::int64_t onset_ns = 0; ///< monotonic clock
    std::string onset_source;  ///< how the onset was observed: "swap_return", "virtual"
    std::string onset_utc;     ///< ISO 8601 with milliseconds and Z
    std::int64_t grey_ns = 0;  ///< when the grey before it began, monotonic clock
    std::int64_t extra_ns = 0; ///< how much longer than planned the grey lasted
    bool operator==(const Shown&) const = default;
};

/// A change of the screen during a trial, or something else that took its time.
struct Frame {
    std::string what;         ///< "grey", "pair", "first", "between", "second", "hidden", "stored"
    std::int64_t due_ns = 0;  ///< when it should have been, monotonic clock
    std::int64_t done_ns = 0; ///< when it was: the buffers' swap had returned, the vote was on disk
    int late = 0;             ///< refreshes of the screen that were missed; 0 where none is known
    bool operator==(const Frame&) const = default;
};

/// What the screen did during a presentation that led to no vote: practice, or interrupted.
struct FramesSeen {
    int trial = 0;
    int presentation = 1;
    std::vector<Frame> frames;
    bool operator==(const FramesSeen&) const = default;
};

/// An answer to a main trial.  Answers to training and warm-ups never come here.
struct MainVote {
    int trial = 0; ///< its number in the plan
    protocols::Choice chosen{};
    std::chrono::milliseconds response_time{};
    std::int64_t onset_ns = 0;
    std::int64_t key_ns = 0;
    std::string onset_utc;
    std::string device;          ///< "keyboard", "mouse", "simulated"
    std::string key_name;        ///< "left", "right"
    int early_keys = 0;          ///< answers pressed before input opened, not taken
    bool held_key = false;       ///< an answer key was already down when the pictures appeared
    std::optional<int> grade{};  ///< -3..3 of the right picture, where grades are asked for
    std::vector<Frame> frames{}; ///< of the presentation that was answered
    bool operator==(const MainVote&) const = default;
};

/// What an observer, or the experimenter about one, has answered before the first sitting.
struct Answer {
    std::string question; ///< its id; "consent" and "screening", too
    std::string answer;
    std::string utc;
    bool operator==(const Answer&) const = default;
};

/// What is left of an observer who wished to be removed.
struct Tombstone {
    std::string utc;
    std::string reason;
    int rows = 0;  ///< that were removed
    int votes = 0; ///< among them
    bool operator==(const Tombstone&) const = default;
};

/// Anything else worth knowing later: a page read, a break, an interruption.
struct SittingEvent {
    std::string kind;
    std::string detail;
    std::int64_t at_ns = 0; ///< monotonic clock
    std::string utc;
    bool operator==(const SittingEvent&) const = default;
};

/// The kind of event that says a main trial will have no vote; its detail is the trial's number.
inline constexpr std::string_view missing_vote = "missing";

/// Everything kept of one sitting.
struct Sitting {
    SittingStart start;
    std::vector<protocols::PlannedTrial> plan;
    std::vector<Shown> shown;
    std::vector<MainVote> votes; ///< in the order they were given
    std::vector<SittingEvent> events;
    std::vector<FramesSeen> frames; ///< of presentations without a vote
    std::optional<std::string> finished_utc;
};

/// A sitting in one line.
struct SittingSummary {
    SittingKey key;
    std::string local_date;
    std::string started_utc;
    std::string study_sha256;
    std::string renderer;
    std::string display;
    std::string timing_grade;
    std::optional<std::string> simulation;
    std::optional<std::string> override_reason;
    std::optional<std::string> finished_utc;
    int votes = 0;
};

/// A vote with everything an analysis needs to know of it.
struct VoteRow {
    std::string study;
    protocols::ObserverId observer;
    int session = 0;
    int trial = 0;
    protocols::Trial pair;
    protocols::Choice chosen{};
    std::chrono::milliseconds response_time{};
    std::string onset_utc;
    bool simulated = false;
    std::optional<int> grade{}; ///< -3..3 of the right picture, where grades are asked for
    bool operator==(const VoteRow&) const = default;
};

} // namespace experiment::store
