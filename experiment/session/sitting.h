// The state machine of a sitting: from what happens to what is seen and what is recorded.
// Pure: no window, no store, no clock; time comes with the inputs.
#pragma once

#include "experiment/session/inputs.h"
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
};

/// What was done in an earlier part of the same sitting.
struct Progress {
    bool training_done = false;       ///< recently enough not to be repeated
    std::set<int> voted;              ///< numbers of the main trials that have a vote
    std::map<int, int> presentations; ///< how often each trial has been on the screen
};

/// The sitting is complete, to be recorded.
struct Finish {
    bool operator==(const Finish&) const = default;
};

/// What has to be recorded, in order and before the next input.  Wall-clock times are left empty.
/// A MainVote wants the input VoteStored in return, and nothing else before it.
using Effect = std::variant<store::Shown, store::MainVote, store::SittingEvent, Finish>;

/// Pages -> training -> questions -> adaptation -> warm-ups -> main, with breaks -> thanks.
///
/// Before every pair there is grey; answers count when they come `closed_ms` after the onset or
/// later.  Escape, or closing the window, asks whether to stop; a pair that was interrupted by that
/// or by a loss of the keyboard is shown again.  The view becomes EndView when all is over.
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

  private:
    enum class State { Page, Adapting, Grey, Pair, Saving, Break, Paused, Doubt, Over };

    struct PageStep {
        std::string name; ///< for the record
        PageView page;
        Monotonic least{};
    };

    struct AdaptationStep {};

    struct FinishStep {};

    using Step = std::variant<PageStep, AdaptationStep, protocols::PlannedTrial, FinishStep>;

    void see(View view);
    void enter(Monotonic at);
    void next(Monotonic at);
    void start_grey(Monotonic at);
    void press(const Pressed& press, Monotonic at);
    void press_on_page(Key key, Monotonic at);
    void press_in_doubt(Key key, Monotonic at);
    void onset(const OnsetSeen& seen, Monotonic at);
    void answer(const Pressed& press, Monotonic at);
    void time_passed(Monotonic at);
    void interrupt(State state, PageView page, const std::string& why, Monotonic at);
    void go_on(Monotonic at);
    void note(std::string kind, std::string detail, Monotonic at);
    bool break_is_due(const protocols::PlannedTrial& planned, Monotonic at) const;
    bool in_trial() const;
    const protocols::PlannedTrial& trial() const;

    SittingScript script_;
    Progress progress_;
    std::vector<Step> steps_;
    std::size_t step_ = 0;
    State state_ = State::Over;
    State interrupted_ = State::Over; ///< where Doubt came from
    View view_ = GreyView{};
    View interrupted_view_ = GreyView{};
    int view_number_ = 0;
    std::vector<Effect> effects_;

    Monotonic since_{};                 ///< beginning of the page, the doubt or the grey
    Monotonic page_since_{};            ///< of the page that was interrupted by doubt
    Monotonic until_{};                 ///< end of the grey or the adaptation
    std::optional<store::Shown> shown_; ///< the pair that is on the screen
    Monotonic answered_{};
    int early_keys_ = 0;
    bool held_key_ = false;
    std::set<Key> down_;
    int main_since_break_ = 0;
    std::optional<Monotonic> stretch_since_; ///< beginning of main trials without a break
};

} // namespace experiment::session
