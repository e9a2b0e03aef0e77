#include "tests/experiment/session/scripted_sitting.h"

#include "tests/experiment/store/small_sitting.h"

#include <fmt/format.h>

namespace tests {

using namespace experiment::session;
using experiment::store::FramesSeen;
using experiment::store::MainVote;
using experiment::store::Shown;
using experiment::store::SittingEvent;
using std::chrono::milliseconds;

namespace {

long long ms_of(std::int64_t ns) {
    return ns / 1'000'000;
}

std::string words(const Effect& effect) {
    if (const auto* shown = std::get_if<Shown>(&effect))
        return fmt::format("shown {} #{} late {} ms", shown->trial, shown->presentation,
                           ms_of(shown->extra_ns));
    if (const auto* vote = std::get_if<MainVote>(&effect))
        return fmt::format("vote {} {} {} ms early {}{}", vote->trial, vote->key_name,
                           vote->response_time.count(), vote->early_keys,
                           vote->held_key ? " held" : "");
    if (const auto* event = std::get_if<SittingEvent>(&effect))
        return fmt::format("event {} {}", event->kind, event->detail);
    if (std::holds_alternative<FramesSeen>(effect))
        return "";
    return "finish";
}

std::string words(const View& view) {
    if (const auto* page = std::get_if<PageView>(&view))
        return "page " + page->text.substr(0, page->text.find('\n'));
    if (const auto* pair = std::get_if<PairView>(&view))
        return fmt::format("pair {}{}", pair->number,
                           pair->part == Part::Both    ? ""
                           : pair->part == Part::First ? " first"
                                                       : " second");
    if (const auto* end = std::get_if<EndView>(&view))
        return end->finished ? "end finished" : "end stopped";
    return "grey";
}

} // namespace

SittingScript short_script(int break_every) {
    SittingScript script{
        {"Welcome", "How to answer"}, "Which is more realistic?", {}, small_plan()};
    script.plan.adapt_s = 1;
    script.plan.break_every = break_every;
    return script;
}

ScriptedSitting::ScriptedSitting(SittingScript script, Progress progress, long long onset_delay_ms)
    : sitting_(std::move(script), std::move(progress)), onset_delay_ms_(onset_delay_ms) {
    write(0, sitting_.begin(milliseconds(0)));
    look(0);
}

Monotonic ScriptedSitting::true_time(long long ms) const {
    return milliseconds(ms + settling_ms_);
}

void ScriptedSitting::feed(long long ms, decltype(Input::what) what) {
    come_of(ms, sitting_.advance({true_time(ms), std::move(what)}));
}

void ScriptedSitting::come_of(long long ms, const std::vector<Effect>& effects) {
    write(ms, effects);
    for (const auto& effect : effects)
        if (std::holds_alternative<MainVote>(effect))
            write(ms, sitting_.advance({true_time(ms), VoteStored{}}));
    look(ms);
}

// The moment in which a second answer could come passes, but not on the diary's clock.
void ScriptedSitting::settle(long long ms) {
    const auto moment = true_time(ms) + TrialCourse::one_moment;
    if (sitting_.wake_at() != moment)
        return;
    const auto effects = sitting_.advance({moment, Waited{}});
    settling_ms_ += TrialCourse::one_moment.count();
    come_of(ms, effects);
}

void ScriptedSitting::write(long long ms, const std::vector<Effect>& effects) {
    for (const auto& effect : effects)
        if (const auto text = words(effect); !text.empty()) // frames are not for the diary
            diary_.push_back(fmt::format("{} {}", ms, text));
}

void ScriptedSitting::look(long long ms) {
    if (sitting_.view_number() == seen_)
        return;
    seen_ = sitting_.view_number();
    diary_.push_back(fmt::format("{} {}", ms, words(sitting_.view())));
    if (std::holds_alternative<PairView>(sitting_.view()))
        write(ms + onset_delay_ms_,
              sitting_.advance({true_time(ms + onset_delay_ms_), OnsetSeen{"scripted"}}));
}

void ScriptedSitting::press(long long ms, Key key, Device device) {
    feed(ms, Pressed{key, device});
    if (std::holds_alternative<EndView>(sitting_.view()))
        return;
    feed(ms, LetGo{key});
    settle(ms);
}

void ScriptedSitting::press_both(long long ms, Key first, long long later_ms, Key second) {
    feed(ms, Pressed{first, Device::Keyboard});
    feed(later_ms, Pressed{second, Device::Keyboard});
    feed(later_ms, LetGo{first});
    feed(later_ms, LetGo{second});
    settle(ms);
}

void ScriptedSitting::press_then_lose_focus(long long ms, Key key, long long later_ms) {
    feed(ms, Pressed{key, Device::Keyboard});
    feed(later_ms, FocusLost{});
}

void ScriptedSitting::change_display(long long ms, const std::string& what) {
    feed(ms, DisplayChanged{what});
}

void ScriptedSitting::repeat(long long ms, Key key) {
    feed(ms, Pressed{key, Device::Keyboard, true});
}

void ScriptedSitting::let_go(long long ms, Key key) {
    feed(ms, LetGo{key});
}

void ScriptedSitting::lose_focus(long long ms) {
    feed(ms, FocusLost{});
}

void ScriptedSitting::close(long long ms) {
    feed(ms, CloseAsked{});
}

void ScriptedSitting::wait_until(long long ms) {
    feed(ms, Waited{});
}

long long ScriptedSitting::pass_to_warm_up() {
    press(2000, Key::Forward);
    press(4000, Key::Forward);
    wait_until(4500); // the training pair, onset at 4510
    press(5000, Key::Left);
    press(6000, Key::Release);
    wait_until(7000);
    return 7000;
}

std::vector<std::string> ScriptedSitting::news() {
    const std::vector<std::string> fresh(diary_.begin() + static_cast<std::ptrdiff_t>(told_),
                                         diary_.end());
    told_ = diary_.size();
    return fresh;
}

} // namespace tests
