// Somebody simulated in front of a screen.
#include "experiment/session/simulated_screen.h"

#include "protocols/contract.h"

namespace experiment::session {

namespace {

constexpr std::chrono::seconds page_reading{15}; // longer than any page has to be open
constexpr std::chrono::seconds first_look{1};    // at a picture that gives way to another

} // namespace

DisplayFacts SimulatedScreen::facts() const {
    const std::string virtual_time = "simulated observer, virtual time";
    if (window_ == nullptr)
        return {"none (" + virtual_time + ")", {}, {}, {}};
    return {virtual_time + "; " + window_->facts().description, {}, {}, {}};
}

void SimulatedScreen::prepare(const PairView& pair) {
    if (window_ != nullptr)
        window_->prepare(pair);
}

SimulatedScreen::Intention SimulatedScreen::intention(const PairView& pair) const {
    const auto given = answer(observer_, study_, name_, session_, pair.number, pair.trial);
    return {clock_.now() + given.response_time, key_of(given, response_)};
}

Expected<Input> SimulatedScreen::show(const View& view) {
    if (window_ != nullptr)
        if (const auto shown = window_->show(view); !shown)
            return shown;
    view_ = view;
    if (const auto* pair = std::get_if<PairView>(&view)) {
        pair_ = *pair;
        intention_ = pair->part == Part::First ? Intention{clock_.now() + first_look, Key::Flip}
                                               : intention(*pair);
    } else if (std::holds_alternative<PageView>(view)) {
        intention_.reset();
    }
    return Input{clock_.now(), OnsetSeen{"virtual"}};
}

std::optional<Input> SimulatedScreen::wait(std::optional<Monotonic> until) {
    const auto* page = std::get_if<PageView>(&view_);
    if (!until && page != nullptr)
        intention_ = {clock_.now() + page_reading, page->advance};
    else if (!until && !intention_) // an answer that came too early is given again
        intention_ = intention(pair_.value());
    if (!intention_ || (until && *until <= intention_->at)) {
        EXPECTS(*until >= clock_.now());
        clock_.advance(*until - clock_.now());
        return std::nullopt;
    }
    const auto next = *std::exchange(intention_, {});
    clock_.advance(next.at - clock_.now());
    return Input{clock_.now(), Pressed{next.key, Device::Simulated}};
}

} // namespace experiment::session
