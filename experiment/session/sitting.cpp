// The state machine of a sitting.
#include "experiment/session/sitting.h"

#include "experiment/session/pages.h"
#include "protocols/contract.h"

#include <fmt/format.h>

#include <utility>

namespace experiment::session {

namespace {

using protocols::Phase;
using protocols::PlannedTrial;
using std::chrono::duration_cast;
using std::chrono::milliseconds;

template <class... Cases>
struct Match : Cases... {
    using Cases::operator()...;
};

template <class... Cases>
Match(Cases...) -> Match<Cases...>;

bool is_answer(Key key) {
    return key == Key::Left || key == Key::Right;
}

std::string name_of(Device device) {
    return device == Device::Keyboard ? "keyboard"
           : device == Device::Mouse  ? "mouse"
                                      : "simulated";
}

long long in_ms(Monotonic duration) {
    return duration_cast<milliseconds>(duration).count();
}

} // namespace

Sitting::Sitting(SittingScript script, Progress progress)
    : script_(std::move(script)), progress_(std::move(progress)) {
    const auto& pages = script_.instructions;
    for (std::size_t i = 0; i < pages.size(); ++i)
        steps_.emplace_back(PageStep{fmt::format("instructions {} of {}", i + 1, pages.size()),
                                     instruction_page(pages[i]), least_reading});
    const auto add_trials = [&](Phase phase) {
        for (const auto& planned : script_.trials)
            if (planned.phase == phase && !progress_.voted.contains(planned.number))
                steps_.emplace_back(planned);
    };
    if (!progress_.training_done)
        add_trials(Phase::Training);
    steps_.emplace_back(PageStep{"questions", question_page(script_.question), {}});
    steps_.emplace_back(AdaptationStep{});
    add_trials(Phase::WarmUp);
    const auto before_main = steps_.size();
    add_trials(Phase::Main);
    // Everything was answered before and only the end is missing: nobody has to wait for it.
    if (steps_.size() == before_main)
        steps_.clear();
    steps_.emplace_back(FinishStep{});
    steps_.emplace_back(PageStep{"thanks", thanks_page(), {}});
}

std::vector<Effect> Sitting::begin(Monotonic at) {
    EXPECTS(view_number_ == 0);
    enter(at);
    return std::exchange(effects_, {});
}

std::vector<Effect> Sitting::advance(const Input& input) {
    EXPECTS(state_ != State::Over);
    const auto at = input.at;
    std::visit(Match{[&](const Pressed& pressed) { press(pressed, at); },
                     [&](const LetGo& let_go) { down_.erase(let_go.key); },
                     [&](const OnsetSeen& seen) { onset(seen, at); },
                     [&](const VoteStored&) {
                         EXPECTS(state_ == State::Saving);
                         next(answered_);
                     },
                     [&](const Waited&) { time_passed(at); },
                     [&](const FocusLost&) {
                         down_.clear(); // keys let go elsewhere are not reported
                         if (in_trial() || state_ == State::Adapting)
                             interrupt(State::Paused, paused_page(), "paused", at);
                     },
                     [&](const CloseAsked&) {
                         press({Key::Escape, Device::Mouse}, at);
                     }},
               input.what);
    return std::exchange(effects_, {});
}

std::optional<Monotonic> Sitting::wake_at() const {
    if (state_ == State::Grey || state_ == State::Adapting)
        return until_;
    return std::nullopt;
}

std::optional<PairView> Sitting::upcoming() const {
    const bool on_screen = state_ == State::Pair || state_ == State::Saving;
    for (auto i = step_ + (on_screen ? 1 : 0); i < steps_.size(); ++i)
        if (const auto* planned = std::get_if<PlannedTrial>(&steps_[i]))
            return PairView{planned->number, planned->trial};
    return std::nullopt;
}

void Sitting::see(View view) {
    view_ = std::move(view);
    ++view_number_;
}

void Sitting::next(Monotonic at) {
    ++step_;
    enter(at);
}

void Sitting::enter(Monotonic at) {
    std::visit(Match{[&](const PageStep& step) {
                         state_ = State::Page;
                         since_ = at;
                         see(step.page);
                     },
                     [&](const AdaptationStep&) {
                         state_ = State::Adapting;
                         since_ = at;
                         until_ = at + std::chrono::seconds(script_.plan.adapt_s);
                         see(GreyView{});
                     },
                     [&](const PlannedTrial& planned) {
                         if (!break_is_due(planned, at))
                             return start_grey(at);
                         state_ = State::Break;
                         since_ = at;
                         see(break_page());
                     },
                     [&](const FinishStep&) {
                         effects_.emplace_back(Finish{});
                         next(at);
                     }},
               steps_[step_]);
}

void Sitting::start_grey(Monotonic at) {
    state_ = State::Grey;
    since_ = at;
    until_ = at + milliseconds(script_.plan.grey_ms);
    shown_.reset();
    early_keys_ = 0;
    held_key_ = false;
    if (trial().phase == Phase::Main && !stretch_since_)
        stretch_since_ = at;
    see(GreyView{});
}

void Sitting::press(const Pressed& press, Monotonic at) {
    if (press.repeated)
        return;
    if (press.device == Device::Keyboard)
        down_.insert(press.key);
    if (state_ == State::Doubt)
        return press_in_doubt(press.key, at);
    if (press.key == Key::Escape && state_ != State::Saving) {
        if (step_ + 1 == steps_.size())
            return press_on_page(Key::Forward, at); // there is nothing left to stop
        return interrupt(State::Doubt, stop_page(), "stop_asked", at);
    }
    if (state_ == State::Pair)
        return answer(press, at);
    if (state_ == State::Grey || state_ == State::Saving)
        early_keys_ += is_answer(press.key) ? 1 : 0;
    else
        press_on_page(press.key, at);
}

void Sitting::press_on_page(Key key, Monotonic at) {
    const auto* page = std::get_if<PageView>(&view_);
    if (page == nullptr || key != page->advance)
        return;
    if (state_ == State::Paused) {
        note("continued", "", at);
        return go_on(at);
    }
    if (state_ == State::Break) {
        if (at - since_ < least_break)
            return;
        note("break", fmt::format("{} ms", in_ms(at - since_)), at);
        main_since_break_ = 0;
        stretch_since_.reset();
        return start_grey(at);
    }
    const auto& step = std::get<PageStep>(steps_[step_]);
    if (at - since_ < step.least)
        return;
    if (step_ + 1 == steps_.size()) {
        state_ = State::Over;
        return see(EndView{true});
    }
    note("page", fmt::format("{}: {} ms", step.name, in_ms(at - since_)), at);
    next(at);
}

void Sitting::press_in_doubt(Key key, Monotonic at) {
    if (at - since_ < least_doubt)
        return;
    if (key == Key::Escape) {
        note("stopped", "", at);
        state_ = State::Over;
        see(EndView{false});
    } else if (key == Key::Forward) {
        note("continued", "", at);
        go_on(at);
    }
}

void Sitting::onset(const OnsetSeen& seen, Monotonic at) {
    EXPECTS(state_ == State::Pair && !shown_);
    const auto number = trial().number;
    shown_ = store::Shown{number,
                          ++progress_.presentations[number],
                          at.count(),
                          seen.source,
                          "",
                          since_.count(),
                          (at - until_).count()};
    held_key_ = down_.contains(Key::Left) || down_.contains(Key::Right);
    effects_.emplace_back(*shown_);
}

void Sitting::answer(const Pressed& press, Monotonic at) {
    if (!is_answer(press.key))
        return;
    const auto onset = shown_ ? Monotonic(shown_->onset_ns) : at;
    if (!shown_ || at - onset < milliseconds(script_.plan.closed_ms)) {
        ++early_keys_;
        return;
    }
    answered_ = at;
    if (trial().phase != Phase::Main)
        return next(at); // the answer is not kept
    const bool left = press.key == Key::Left;
    effects_.emplace_back(
        store::MainVote{trial().number, left ? protocols::Choice::Left : protocols::Choice::Right,
                        std::chrono::round<milliseconds>(at - onset), onset.count(), at.count(), "",
                        name_of(press.device), left ? "left" : "right", early_keys_, held_key_});
    ++main_since_break_;
    state_ = State::Saving;
    see(GreyView{});
}

void Sitting::time_passed(Monotonic at) {
    if (!wake_at() || at < until_)
        return;
    if (state_ == State::Adapting) {
        note("adaptation", fmt::format("{} ms", in_ms(at - since_)), at);
        return next(at);
    }
    state_ = State::Pair;
    see(PairView{trial().number, trial().trial});
}

void Sitting::interrupt(State state, PageView page, const std::string& why, Monotonic at) {
    note(why, in_trial() ? fmt::format("trial {}", trial().number) : "", at);
    // Doubt during a pause leads back to the pause.
    interrupted_ = state_;
    interrupted_view_ = view_;
    page_since_ = since_;
    state_ = state;
    since_ = at;
    see(std::move(page));
}

void Sitting::go_on(Monotonic at) {
    const bool from_grey = interrupted_ == State::Grey || interrupted_ == State::Pair;
    if (state_ == State::Paused || from_grey)
        return enter(at); // the pair again, or the adaptation
    state_ = interrupted_;
    since_ = page_since_;
    see(interrupted_view_);
}

void Sitting::note(std::string kind, std::string detail, Monotonic at) {
    effects_.emplace_back(store::SittingEvent{std::move(kind), std::move(detail), at.count(), ""});
}

bool Sitting::break_is_due(const PlannedTrial& planned, Monotonic at) const {
    if (planned.phase != Phase::Main || script_.plan.break_every == 0 || main_since_break_ == 0)
        return false;
    return main_since_break_ >= script_.plan.break_every ||
           (stretch_since_ && at - *stretch_since_ >= longest_stretch);
}

bool Sitting::in_trial() const {
    return state_ == State::Grey || state_ == State::Pair;
}

const PlannedTrial& Sitting::trial() const {
    return std::get<PlannedTrial>(steps_[step_]);
}

} // namespace experiment::session
