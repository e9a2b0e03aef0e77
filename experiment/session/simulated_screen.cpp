// A screen that a simulated observer sits in front of.
#include "experiment/session/simulated_screen.h"

#include "protocols/contract.h"

namespace experiment::session {

namespace {

constexpr std::chrono::seconds page_reading{15}; // longer than any page has to be open

} // namespace

DisplayFacts SimulatedScreen::facts() const {
    return {"none (simulated observer, virtual time)", "U"};
}

Expected<Input> SimulatedScreen::show(const View& view) {
    view_ = view;
    return Input{clock_.now(), OnsetSeen{"virtual"}};
}

std::optional<Input> SimulatedScreen::wait(std::optional<Monotonic> until) {
    if (until) {
        EXPECTS(*until >= clock_.now());
        clock_.advance(*until - clock_.now());
        return std::nullopt;
    }
    if (const auto* pair = std::get_if<PairView>(&view_)) {
        const auto given = answer(observer_, study_, name_, session_, pair->number, pair->trial);
        clock_.advance(given.response_time);
        const auto key = given.side == protocols::Side::Left ? Key::Left : Key::Right;
        return Input{clock_.now(), Pressed{key, Device::Simulated}};
    }
    const auto* page = std::get_if<PageView>(&view_);
    EXPECTS(page != nullptr); // grey ends by itself
    clock_.advance(page_reading);
    return Input{clock_.now(), Pressed{page->advance, Device::Simulated}};
}

} // namespace experiment::session
