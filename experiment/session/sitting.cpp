// The state machine of a sitting.
#include "experiment/session/sitting.h"

#include "protocols/contract.h"
#include "protocols/session_length.h"

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

long long in_ms(Monotonic duration) {
    return duration_cast<milliseconds>(duration).count();
}

// One refresh later than due is as soon as a screen can; a fifth more is the clocks' doubt.
int refreshes_missed(const store::Frame& frame, Monotonic refresh) {
    const auto delay = frame.done_ns - frame.due_ns;
    return refresh.count() <= 0 || delay * 5 <= refresh.count() * 6
               ? 0
               : static_cast<int>(delay / refresh.count());
}

} // namespace

Sitting::Sitting(SittingScript script, Progress progress)
    : script_(std::move(script)), progress_(std::move(progress)) {
    add_pages();
    if (!progress_.training_done)
        agenda_.add_training(open_trials(Phase::Training));
    agenda_.add(PageStep{
        "questions", question_page(script_.style, script_.question, agenda_.has_training()), {}});
    agenda_.add(AdaptationStep{});
    for (const auto& trial : open_trials(Phase::WarmUp))
        agenda_.add(trial);
    const auto main = open_trials(Phase::Main);
    for (const auto& trial : main)
        agenda_.add(trial);
    // Everything was answered before and only the end is missing: nobody has to wait for it.
    if (main.empty())
        agenda_.clear();
    agenda_.add(FinishStep{});
    agenda_.add(PageStep{"thanks", thanks_page(script_.style), {}});
}

void Sitting::add_pages() {
    for (const auto& page : script_.setting_up)
        agenda_.add(PageStep{page.patches.empty() ? "display" : "contrast", page, {}});
    const auto& pages = script_.instructions;
    for (std::size_t i = 0; i < pages.size(); ++i)
        agenda_.add(PageStep{fmt::format("instructions {} of {}", i + 1, pages.size()),
                             instruction_page(script_.style, pages[i]), least_reading});
}

std::vector<PlannedTrial> Sitting::open_trials(Phase phase) const {
    std::vector<PlannedTrial> trials;
    for (const auto& planned : script_.trials)
        if (planned.phase == phase && !progress_.voted.contains(planned.number) &&
            !progress_.missing.contains(planned.number))
            trials.push_back(planned);
    return trials;
}

std::vector<Effect> Sitting::begin(Monotonic at) {
    EXPECTS(view_number_ == 0);
    begun_ = at;
    enter(at);
    return std::exchange(effects_, {});
}

std::vector<Effect> Sitting::advance(const Input& input) {
    EXPECTS(state_ != State::Over);
    // Whatever happens in the moment in which another answer could contradict the first one waits
    // until the vote is stored; only such an answer, and a picture's appearance, does not.
    const bool waits = state_ == State::Trial && course_->is_deciding() &&
                       !std::holds_alternative<Waited>(input.what) &&
                       !std::holds_alternative<OnsetSeen>(input.what) &&
                       !std::holds_alternative<LetGo>(input.what);
    const auto* pressed = std::get_if<Pressed>(&input.what);
    if (waits &&
        (pressed == nullptr || pressed->key == Key::Escape || course_->is_settled(input.at))) {
        deferred_ = input;
        settle(input.at);
    } else {
        handle(input);
    }
    return std::exchange(effects_, {});
}

void Sitting::handle(const Input& input) {
    const auto at = input.at;
    std::visit(Match{[&](const Pressed& pressed) { press(pressed, at); },
                     [&](const LetGo& let_go) { down_.erase(let_go.key); },
                     [&](const OnsetSeen& seen) {
                         if (state_ != State::Trial)
                             return;
                         if (auto shown = course_->seen(seen, at, down_))
                             effects_.emplace_back(std::move(*shown));
                     },
                     [&](const VoteStored&) { vote_stored(at); },
                     [&](const Waited&) { time_passed(at); },
                     [&](const FocusLost&) {
                         down_.clear(); // keys let go elsewhere are not reported
                         if (state_ == State::Trial || state_ == State::Adapting)
                             pause(PauseReason::WindowLeft, "", at);
                     },
                     [&](const DisplayChanged& changed) {
                         note("display_changed", changed.what, at);
                         if (state_ == State::Trial || state_ == State::Adapting)
                             pause(PauseReason::ScreenChanged, changed.what, at);
                     },
                     [&](const CloseAsked&) {
                         press({Key::Escape, Device::Mouse}, at);
                     }},
               input.what);
}

std::optional<Monotonic> Sitting::wake_at() const {
    if (state_ == State::Trial)
        return course_->wake_at();
    if (state_ == State::Adapting)
        return until_;
    return std::nullopt;
}

std::optional<PairView> Sitting::upcoming() const {
    const bool on_screen =
        state_ == State::Saving || (state_ == State::Trial && course_->was_seen());
    const auto* planned = agenda_.upcoming(!on_screen);
    return planned != nullptr ? std::optional(PairView{planned->number, planned->trial})
                              : std::nullopt;
}

void Sitting::see(View view) {
    view_ = std::move(view);
    ++view_number_;
}

void Sitting::next(Monotonic at) {
    agenda_.next();
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
                     [&](const PlannedTrial& planned) { enter_trial(planned, at); },
                     [&](const FinishStep&) {
                         effects_.emplace_back(Finish{});
                         next(at);
                     }},
               agenda_.current());
}

void Sitting::enter_trial(const PlannedTrial& planned, Monotonic at) {
    if (planned.phase != Phase::Main)
        return start_trial(at);
    if (limit_is_reached(at)) {
        state_ = State::Limit;
        note("limit_reached", fmt::format("{} ms", in_ms(at - begun_)), at);
    } else if (break_is_due(at)) {
        state_ = State::Break;
    } else {
        return start_trial(at);
    }
    since_ = at;
    see(state_ == State::Limit ? limit_page(script_.style) : break_page(script_.style));
}

void Sitting::start_trial(Monotonic at) {
    state_ = State::Trial;
    const auto number = trial().number;
    course_.emplace(script_.plan, trial(), progress_.presentations[number] + 1, script_.lead, at);
    course_changes_ = 0;
    if (trial().phase == Phase::Main) {
        stretch_since_ = stretch_since_.value_or(at);
        main_since_ = main_since_.value_or(at);
    }
    see(course_->view());
}

// What the course of the trial has come to.
void Sitting::follow_trial(Monotonic at) {
    if (course_->is_ambiguous()) {
        note("ambiguous", fmt::format("trial {}: two answers at once", trial().number), at);
        return ask_again_later(at);
    }
    if (course_->is_expired())
        return pass_deadline(at);
    if (course_->is_settled(at))
        return settle(at);
    if (course_->changes() != course_changes_) {
        course_changes_ = course_->changes();
        see(course_->view());
    }
}

std::vector<store::Frame> Sitting::frames_so_far() const {
    auto frames = course_->frames();
    if (stored_)
        frames.insert(frames.begin(), *stored_);
    for (auto& frame : frames)
        if (frame.what != "stored")
            frame.late = refreshes_missed(frame, script_.refresh);
    return frames;
}

// The screen's times are kept of every presentation; those of a vote go with it.
void Sitting::leave_trial() {
    auto frames = frames_so_far();
    stored_.reset();
    if (course_->was_seen()) {
        progress_.presentations[trial().number] = course_->presentation();
        effects_.emplace_back(
            store::FramesSeen{trial().number, course_->presentation(), std::move(frames)});
    }
}

void Sitting::settle(Monotonic at) {
    if (trial().phase != Phase::Main) { // the answer is not kept
        leave_trial();
        next(at);
        if (deferred_)
            handle(*std::exchange(deferred_, {}));
        return;
    }
    auto vote = course_->vote();
    vote.frames = frames_so_far();
    stored_ = store::Frame{"stored", vote.key_ns, 0};
    progress_.presentations[trial().number] = course_->presentation();
    effects_.emplace_back(std::move(vote));
    ++main_since_break_;
    ++answered_;
    state_ = State::Saving;
    see(GreyView{});
}

void Sitting::vote_stored(Monotonic at) {
    EXPECTS(state_ == State::Saving);
    stored_->done_ns = at.count();
    next(at);
    if (deferred_)
        handle(*std::exchange(deferred_, {}));
}

// A vote that is missing is on record as such, and never becomes a tie.
void Sitting::pass_deadline(Monotonic at) {
    const auto number = trial().number;
    const bool is_main = trial().phase == Phase::Main;
    note("deadline", fmt::format("trial {}", number), at);
    if (is_main && script_.plan.after_deadline == protocols::AfterDeadline::Again &&
        progress_.expired.insert(number).second)
        return ask_again_later(at);
    leave_trial();
    if (is_main) {
        note(std::string(store::missing_vote), fmt::format("{}", number), at);
        progress_.missing.insert(number);
        ++main_since_break_;
    }
    next(at);
}

void Sitting::ask_again_later(Monotonic at) {
    leave_trial();
    agenda_.postpone_trial();
    enter(at);
}

void Sitting::press(const Pressed& press, Monotonic at) {
    if (press.repeated)
        return;
    if (press.device == Device::Keyboard)
        down_.insert(press.key);
    if (state_ == State::Doubt)
        return press_in_doubt(press.key, at);
    if (press.key == Key::Escape && state_ != State::Saving) {
        if (agenda_.is_last())
            return press_on_page(Key::Forward, at); // there is nothing left to stop
        return interrupt(State::Doubt, stop_page(script_.style), "stop_asked", at);
    }
    if (state_ == State::Trial) {
        course_->press(press, at);
        return follow_trial(at);
    }
    press_on_page(press.key, at);
}

void Sitting::press_on_page(Key key, Monotonic at) {
    const auto* page = std::get_if<PageView>(&view_);
    if (page == nullptr)
        return;
    const bool at_questions = state_ == State::Page && page->advance == Key::Release;
    if (key == Key::Again && at_questions && agenda_.repeat_training()) {
        note("training_again", "", at);
        return enter(at);
    }
    if (key != page->advance)
        return;
    if (state_ == State::Paused) {
        note("continued", "", at);
        return go_on(at);
    }
    if (state_ == State::Limit) {
        note("limit_passed", "", at);
        limit_waived_ = true;
        return enter(at);
    }
    if (state_ == State::Break)
        return end_break(at);
    const auto& step = std::get<PageStep>(agenda_.current());
    if (at - since_ < step.least)
        return;
    if (agenda_.is_last()) {
        state_ = State::Over;
        return see(EndView{true});
    }
    note("page", fmt::format("{}: {} ms", step.name, in_ms(at - since_)), at);
    next(at);
}

void Sitting::end_break(Monotonic at) {
    if (at - since_ < least_break)
        return;
    note("break", fmt::format("{} ms", in_ms(at - since_)), at);
    main_since_break_ = 0;
    stretch_since_.reset();
    start_trial(at);
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

void Sitting::time_passed(Monotonic at) {
    if (!wake_at() || at < *wake_at())
        return;
    if (state_ == State::Adapting) {
        note("adaptation", fmt::format("{} ms", in_ms(at - since_)), at);
        return next(at);
    }
    course_->time_passed(at);
    follow_trial(at);
}

void Sitting::pause(PauseReason reason, const std::string& detail, Monotonic at) {
    interrupt(State::Paused, paused_page(script_.style, reason),
              detail.empty() ? "paused" : "paused_by_display", at);
}

void Sitting::interrupt(State state, PageView page, const std::string& why, Monotonic at) {
    const bool in_trial = state_ == State::Trial;
    note(why, in_trial ? fmt::format("trial {}", trial().number) : "", at);
    if (in_trial)
        leave_trial();
    // Doubt during a pause leads back to the pause.
    interrupted_ = state_;
    interrupted_view_ = view_;
    page_since_ = since_;
    state_ = state;
    since_ = at;
    see(std::move(page));
}

void Sitting::go_on(Monotonic at) {
    if (state_ == State::Paused || interrupted_ == State::Trial)
        return enter(at); // the pair again, or the adaptation
    state_ = interrupted_;
    since_ = page_since_;
    see(interrupted_view_);
}

void Sitting::note(std::string kind, std::string detail, Monotonic at) {
    effects_.emplace_back(store::SittingEvent{std::move(kind), std::move(detail), at.count(), ""});
}

bool Sitting::break_is_due(Monotonic at) const {
    if (script_.plan.break_every == 0 || main_since_break_ == 0)
        return false;
    return main_since_break_ >= script_.plan.break_every ||
           (stretch_since_ && at - *stretch_since_ >= longest_stretch);
}

bool Sitting::limit_is_reached(Monotonic at) const {
    return script_.plan.longest_minutes > 0 && !limit_waived_ &&
           at - begun_ >= std::chrono::minutes(script_.plan.longest_minutes);
}

const PlannedTrial& Sitting::trial() const {
    return agenda_.trial();
}

Standing Sitting::standing(Monotonic at) const {
    Standing standing;
    const auto [main, others] = agenda_.remaining();
    standing.main = main;
    if (state_ == State::Saving)
        --standing.main;
    const auto remaining = standing.main;
    standing.answered = answered_ + static_cast<int>(progress_.voted.size());
    standing.main += standing.answered;
    auto pace = duration_cast<Monotonic>(protocols::planned_pair_time);
    if (answered_ >= 3) // enough to say how fast this observer is
        pace = (at - *main_since_) / answered_;
    standing.left = duration_cast<std::chrono::seconds>(pace * (remaining + others));
    static constexpr const char* states[] = {
        "page", "adaptation", "trial", "trial", "break", "limit", "paused", "asks to stop", "over"};
    standing.doing = states[static_cast<std::size_t>(state_)];
    if (state_ == State::Page)
        standing.doing = std::get<PageStep>(agenda_.current()).name;
    else if (state_ == State::Trial || state_ == State::Saving)
        standing.doing = trial().phase == Phase::Training ? "training" : "main trials";
    return standing;
}

} // namespace experiment::session
