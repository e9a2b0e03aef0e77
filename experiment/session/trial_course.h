// One trial, from its grey to its answer.  Pure: time comes with what happens.
#pragma once

#include "experiment/session/inputs.h"
#include "experiment/session/views.h"
#include "experiment/store/records.h"
#include "protocols/schedule.h"

#include <optional>
#include <set>
#include <vector>

namespace experiment::session {

/// Whether a key answers a trial, and what it then says.
bool is_answer(Key key, protocols::Response response);
protocols::Choice choice_of(Key key);

/// -3 (the right one is much worse) ... 3; empty for keys that grade nothing.
std::optional<int> grade_of(Key key);

/// How a key is called on record: "left", "not_sure", "much_worse", ...
std::string name_of(Key key);

/// Grey, then the pictures: at once, one after the other, or one in place of the other.  Answers
/// count `closed_ms` after the last of them appeared, or later, until `deadline_s` after it.  The
/// first answer counts, unless another one follows within `one_moment`: then nobody can say which
/// was meant.
class TrialCourse {
  public:
    static constexpr std::chrono::milliseconds one_moment{10};

    /// `lead`: how long before a picture is due it has to be asked for.
    TrialCourse(const protocols::SessionPlan& plan,
                protocols::PlannedTrial trial,
                int presentation,
                Monotonic lead,
                Monotonic at);

    const View& view() const { return view_; }

    /// Grows with every change of the view.
    int changes() const { return changes_; }

    std::optional<Monotonic> wake_at() const;

    /// The view is visible since `at`.  `down`: the keys that are held.  Returns what has to be
    /// recorded at the first sight of the pictures.
    std::optional<store::Shown>
    seen(const OnsetSeen& onset, Monotonic at, const std::set<Key>& down);

    void press(const Pressed& press, Monotonic at);
    void time_passed(Monotonic at);

    /// There is an answer, and no other can contradict it any more.
    bool is_settled(Monotonic at) const;

    /// An answer was given, and may still be contradicted.
    bool is_deciding() const { return answer_ && !ambiguous_; }

    bool is_ambiguous() const { return ambiguous_; }

    /// The study's deadline has passed and there is no answer.
    bool is_expired() const { return expired_; }

    /// EXPECTS an answer.
    store::MainVote vote() const;

    /// When the answer's key was pressed.  EXPECTS an answer.
    Monotonic answered_at() const;

    const std::vector<store::Frame>& frames() const { return frames_; }

    bool was_seen() const { return first_onset_.has_value(); }

    const protocols::PlannedTrial& planned() const { return trial_; }

    int presentation() const { return presentation_; }

  private:
    enum class State { Grey, First, Between, Complete, Open };

    struct Given {
        Pressed press;
        Monotonic at{};
    };

    void show(State state, View view, Monotonic asked);
    void show_part(State state, Part part, Monotonic asked);
    std::string name_of_view() const;
    bool takes_answers(Monotonic at) const;
    std::optional<Monotonic> deadline() const;

    protocols::SessionPlan plan_;
    protocols::PlannedTrial trial_;
    int presentation_;
    Monotonic lead_;
    State state_ = State::Grey;
    View view_ = GreyView{};
    int changes_ = 0;
    Monotonic asked_{};                    ///< when the view was due
    Monotonic grey_since_{};               ///< when the grey could be seen
    std::optional<Monotonic> until_;       ///< end of what is on the screen
    std::optional<Monotonic> first_onset_; ///< of any picture
    std::optional<Monotonic> complete_;    ///< when all pictures have been on the screen
    std::optional<Given> answer_;
    bool ambiguous_ = false;
    bool expired_ = false;
    int early_keys_ = 0;
    bool held_key_ = false;
    std::vector<store::Frame> frames_;
};

} // namespace experiment::session
