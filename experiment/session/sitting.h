// The state machine of a sitting: from what happens to what is seen and what is recorded.
// Pure: no window, no store, no clock; time comes with the inputs.
#pragma once

#include "experiment/session/agenda.h"
#include "experiment/session/inputs.h"
#include "experiment/session/pages.h"
#include "experiment/session/trial_course.h"
#include "experiment/session/views.h"
#include "experiment/store/records.h"
#include "protocols/schedule.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace experiment::session {

/// What a sitting consists of.
struct SittingScript {
    std::vector<std::string> instructions; ///< pages
    std::string question;
    protocols::SessionPlan plan;
    std::vector<protocols::PlannedTrial> trials; ///< training, warm-ups, main
    PageStyle style{};                           ///< of the built-in pages
    std::vector<PageView> setting_up{};          ///< the experimenter's pages, before all others
    Monotonic refresh{};                         ///< of the screen; 0: not known
    Monotonic lead{}; ///< a picture is asked for so long before it is due
};

/// How far a sitting has come, for the experimenter.
struct Standing {
    std::string doing; ///< "instructions 1 of 5", "training", "main", "break", "paused", ...
    int answered = 0;  ///< main trials with an answer
    int main = 0;      ///< all of them
    std::chrono::seconds left{}; ///< until the end, by the pace so far
};

/// What was done in an earlier part of the same sitting.
struct Progress {
    bool training_done = false;       ///< recently enough not to be repeated
    std::set<int> voted;              ///< numbers of the main trials that have a vote
    std::set<int> missing;            ///< and of those that will have none
    std::set<int> expired;            ///< trials whose deadline has passed once
    std::map<int, int> presentations; ///< how often each trial has been on the screen
};

/// The sitting is complete, to be recorded.
struct Finish {
    bool operator==(const Finish&) const = default;
};

/// What has to be recorded, in order and before the next input.  Wall-clock times are left empty.
/// A MainVote wants the input VoteStored in return, and nothing else before it.
using Effect =
    std::variant<store::Shown, store::FramesSeen, store::MainVote, store::SittingEvent, Finish>;

/// Pages -> training, again and again until the observer is ready -> questions -> adaptation ->
/// warm-ups -> main, with breaks -> thanks.
///
/// What happens within a trial is TrialCourse's.  Escape, or closing the window, asks whether to
/// stop; a pair that was interrupted by that, by a loss of the keyboard or by a change of the
/// screen is shown again, and one with two answers at once comes again later, as does one whose
/// deadline has passed, where the study wants that.  After `longest_minutes` the experimenter
/// decides.  The view becomes EndView when all is over.
class Sitting {
  public:
    static constexpr std::chrono::seconds least_reading{2};      ///< of a page of instructions
    static constexpr std::chrono::seconds least_break{10};       ///< before it can be ended
    static constexpr std::chrono::minutes longest_stretch{10};   ///< of main trials without a break
    static constexpr std::chrono::milliseconds least_doubt{500}; ///< before Escape means stop

    Sitting(SittingScript script, Progress progress);

    /// Opens the sitting; call once, first.
    std::vector<Effect> begin(Monotonic at);

    /// EXPECTS(the sitting has begun and is not over).
    std::vector<Effect> advance(const Input& input);

    const View& view() const { return view_; }

    /// Grows with every change of the view, even to one that looks the same.
    int view_number() const { return view_number_; }

    /// When `Waited` is wanted, if nothing else happens before.
    std::optional<Monotonic> wake_at() const;

    /// The pair that will be shown next, to make it ready.
    std::optional<PairView> upcoming() const;

    Standing standing(Monotonic at) const;

  private:
    enum class State { Page, Adapting, Trial, Saving, Break, Limit, Paused, Doubt, Over };

    void add_pages();
    std::vector<protocols::PlannedTrial> open_trials(protocols::Phase phase) const;
    void see(View view);
    void enter(Monotonic at);
    void enter_trial(const protocols::PlannedTrial& planned, Monotonic at);
    void next(Monotonic at);
    void start_trial(Monotonic at);
    void follow_trial(Monotonic at);
    void settle(Monotonic at);
    void leave_trial();
    void ask_again_later(Monotonic at);
    void pass_deadline(Monotonic at);
    void handle(const Input& input);
    void press(const Pressed& press, Monotonic at);
    void press_on_page(Key key, Monotonic at);
    void end_break(Monotonic at);
    void press_in_doubt(Key key, Monotonic at);
    void vote_stored(Monotonic at);
    void time_passed(Monotonic at);
    void interrupt(State state, PageView page, const std::string& why, Monotonic at);
    void pause(PauseReason reason, const std::string& detail, Monotonic at);
    void go_on(Monotonic at);
    void note(std::string kind, std::string detail, Monotonic at);
    bool break_is_due(Monotonic at) const;
    bool limit_is_reached(Monotonic at) const;
    const protocols::PlannedTrial& trial() const;
    std::vector<store::Frame> frames_so_far() const;

    SittingScript script_;
    Progress progress_;
    Agenda agenda_;
    State state_ = State::Over;
    State interrupted_ = State::Over; ///< where Doubt came from
    View view_ = GreyView{};
    View interrupted_view_ = GreyView{};
    int view_number_ = 0;
    std::vector<Effect> effects_;
    std::optional<Input> deferred_; ///< came while an answer waited to be settled

    Monotonic begun_{};                  ///< the sitting, or this part of it
    Monotonic since_{};                  ///< beginning of the page, the doubt or the adaptation
    Monotonic page_since_{};             ///< of the page that was interrupted by doubt
    Monotonic until_{};                  ///< end of the adaptation
    std::optional<TrialCourse> course_;  ///< of the trial at hand
    int course_changes_ = 0;             ///< of its view, seen so far
    std::optional<store::Frame> stored_; ///< the vote before, on its way to the disk
    bool limit_waived_ = false;
    std::set<Key> down_;
    int answered_ = 0; ///< main trials, in this part of the sitting
    int main_since_break_ = 0;
    std::optional<Monotonic> main_since_;    ///< beginning of the main trials
    std::optional<Monotonic> stretch_since_; ///< beginning of main trials without a break
};

} // namespace experiment::session
