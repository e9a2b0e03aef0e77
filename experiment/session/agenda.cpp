#include "experiment/session/agenda.h"

#include "protocols/contract.h"

namespace experiment::session {

using protocols::Phase;
using protocols::PlannedTrial;

void Agenda::add_training(const std::vector<PlannedTrial>& trials) {
    if (!trials.empty())
        training_ = steps_.size();
    steps_.insert(steps_.end(), trials.begin(), trials.end());
}

void Agenda::clear() {
    steps_.clear();
    training_.reset();
}

const PlannedTrial& Agenda::trial() const {
    const auto* planned = std::get_if<PlannedTrial>(&steps_[at_]);
    EXPECTS(planned != nullptr);
    return *planned;
}

bool Agenda::repeat_training() {
    if (!training_ || *training_ >= at_)
        return false;
    at_ = *training_;
    return true;
}

void Agenda::postpone_trial() {
    const auto again = trial();
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(at_));
    const auto scene_at = [&](std::size_t i) -> const protocols::SceneId* {
        const auto* planned = i < steps_.size() ? std::get_if<PlannedTrial>(&steps_[i]) : nullptr;
        return planned != nullptr && planned->phase == again.phase ? &planned->trial.scene
                                                                   : nullptr;
    };
    auto place = at_;
    while (scene_at(place) != nullptr)
        ++place; // behind the last of its kind
    const auto is_own = [&](const protocols::SceneId* scene) {
        return scene != nullptr && *scene == again.trial.scene;
    };
    for (auto i = at_ + 1; i < place; ++i)
        if (!is_own(scene_at(i - 1)) && !is_own(scene_at(i))) {
            place = i;
            break;
        }
    steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(place), again);
}

const PlannedTrial* Agenda::upcoming(bool with_current) const {
    for (auto i = at_ + (with_current ? 0 : 1); i < steps_.size(); ++i)
        if (const auto* planned = std::get_if<PlannedTrial>(&steps_[i]))
            return planned;
    return nullptr;
}

Agenda::Remaining Agenda::remaining() const {
    Remaining trials;
    for (auto i = at_; i < steps_.size(); ++i)
        if (const auto* planned = std::get_if<PlannedTrial>(&steps_[i]))
            ++(planned->phase == Phase::Main ? trials.main : trials.others);
    return trials;
}

} // namespace experiment::session
