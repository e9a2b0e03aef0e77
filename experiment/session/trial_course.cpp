// One trial, from its grey to its answer.
#include "experiment/session/trial_course.h"

#include "protocols/contract.h"

#include <algorithm>
#include <array>
#include <utility>

namespace experiment::session {

namespace {

using protocols::Choice;
using protocols::Presentation;
using protocols::Response;
using std::chrono::milliseconds;

std::string name_of(Device device) {
    return device == Device::Keyboard ? "keyboard"
           : device == Device::Mouse  ? "mouse"
                                      : "simulated";
}

} // namespace

std::optional<int> grade_of(Key key) {
    if (key < Key::MuchWorse || key > Key::MuchBetter)
        return std::nullopt;
    return static_cast<int>(key) - static_cast<int>(Key::Same);
}

bool is_answer(Key key, Response response) {
    if (response == Response::SevenGrades)
        return grade_of(key).has_value();
    return key == Key::Left || key == Key::Right ||
           (key == Key::NotSure && response == Response::WithNotSure);
}

Choice choice_of(Key key) {
    if (const auto grade = grade_of(key))
        return *grade < 0 ? Choice::Left : *grade > 0 ? Choice::Right : Choice::Tie;
    EXPECTS(key == Key::Left || key == Key::Right || key == Key::NotSure);
    return key == Key::Left ? Choice::Left : key == Key::Right ? Choice::Right : Choice::Tie;
}

std::string name_of(Key key) {
    static constexpr std::array names{"left",   "right",          "not_sure", "much_worse",
                                      "worse",  "slightly_worse", "same",     "slightly_better",
                                      "better", "much_better"};
    const auto index = static_cast<std::size_t>(key);
    return index < names.size() ? names[index] : "other";
}

TrialCourse::TrialCourse(const protocols::SessionPlan& plan,
                         protocols::PlannedTrial trial,
                         int presentation,
                         Monotonic lead,
                         Monotonic at)
    : plan_(plan), trial_(std::move(trial)), presentation_(presentation), lead_(lead), asked_(at),
      grey_since_(at), until_(at + milliseconds(plan.grey_ms)) {}

std::optional<Monotonic> TrialCourse::wake_at() const {
    if (answer_)
        return answer_->at + one_moment;
    if (state_ == State::Grey)
        return *until_ - lead_;
    const auto end = deadline();
    return until_ && end ? std::min(*until_, *end) : until_ ? until_ : end;
}

std::optional<Monotonic> TrialCourse::deadline() const {
    if (!complete_ || plan_.deadline_s == 0)
        return std::nullopt;
    return *complete_ + std::chrono::seconds(plan_.deadline_s);
}

void TrialCourse::show(State state, View view, Monotonic asked) {
    state_ = state;
    view_ = std::move(view);
    asked_ = asked;
    until_.reset();
    ++changes_;
}

void TrialCourse::show_part(State state, Part part, Monotonic asked) {
    show(state, PairView{trial_.number, trial_.trial, part}, asked);
}

std::string TrialCourse::name_of_view() const {
    const auto* pair = std::get_if<PairView>(&view_);
    if (pair == nullptr)
        return state_ == State::Grey ? "grey" : state_ == State::Between ? "between" : "hidden";
    return pair->part == Part::Both ? "pair" : pair->part == Part::First ? "first" : "second";
}

// Until a view has been seen, its time does not run; only the first grey's does, which may follow
// another grey without a change to be seen.
std::optional<store::Shown>
TrialCourse::seen(const OnsetSeen& onset, Monotonic at, const std::set<Key>& down) {
    frames_.push_back({name_of_view(), asked_.count(), at.count()});
    const auto view_time = milliseconds(plan_.view_ms);
    switch (state_) {
    case State::Grey:
        grey_since_ = at;
        until_ = at + milliseconds(plan_.grey_ms);
        return std::nullopt;
    case State::Between:
        until_ = at + milliseconds(plan_.between_ms);
        return std::nullopt;
    case State::Open:
        return std::nullopt;
    case State::First:
        if (plan_.presentation == Presentation::Sequential)
            until_ = at + view_time;
        break;
    case State::Complete:
        if (!complete_)
            complete_ = at;
        if (plan_.view_ms > 0)
            until_ = *complete_ + view_time;
        break;
    }
    if (first_onset_)
        return std::nullopt;
    first_onset_ = at;
    for (const auto key : down)
        held_key_ = held_key_ || is_answer(key, plan_.response);
    return store::Shown{trial_.number,       presentation_,        at.count(), onset.source, "",
                        grey_since_.count(), (at - asked_).count()};
}

bool TrialCourse::takes_answers(Monotonic at) const {
    return complete_ && at - *complete_ >= milliseconds(plan_.closed_ms);
}

void TrialCourse::press(const Pressed& press, Monotonic at) {
    if (press.key == Key::Flip && plan_.presentation == Presentation::Flip && first_onset_ &&
        !answer_ && state_ != State::Open) {
        const auto* pair = std::get_if<PairView>(&view_);
        return show_part(State::Complete, pair->part == Part::First ? Part::Second : Part::First,
                         at);
    }
    if (!is_answer(press.key, plan_.response))
        return;
    if (answer_) {
        ambiguous_ =
            ambiguous_ || (press.key != answer_->press.key && at - answer_->at < one_moment);
        return;
    }
    if (deadline() && at >= *deadline())
        expired_ = true;
    else if (takes_answers(at))
        answer_ = Given{press, at};
    else
        ++early_keys_;
}

void TrialCourse::time_passed(Monotonic at) {
    if (answer_)
        return;
    expired_ = deadline() && at >= *deadline();
    if (expired_ || !until_ || at < *wake_at())
        return;
    switch (state_) {
    case State::Grey:
        if (plan_.presentation == Presentation::SideBySide)
            return show_part(State::Complete, Part::Both, *until_);
        return show_part(State::First, Part::First, *until_);
    case State::First:
        return show(State::Between, GreyView{}, *until_);
    case State::Between:
        return show_part(State::Complete, Part::Second, *until_);
    case State::Complete:
        return show(State::Open, GreyView{}, *until_);
    case State::Open:
        return;
    }
}

bool TrialCourse::is_settled(Monotonic at) const {
    return answer_ && !ambiguous_ && at - answer_->at >= one_moment;
}

Monotonic TrialCourse::answered_at() const {
    EXPECTS(answer_.has_value());
    return answer_->at;
}

store::MainVote TrialCourse::vote() const {
    EXPECTS(answer_ && complete_);
    const auto& [press, at] = *answer_;
    return {trial_.number,
            session::choice_of(press.key),
            std::chrono::round<milliseconds>(at - *complete_),
            complete_->count(),
            at.count(),
            "",
            name_of(press.device),
            session::name_of(press.key),
            early_keys_,
            held_key_,
            grade_of(press.key),
            frames_};
}

} // namespace experiment::session
