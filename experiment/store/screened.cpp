// Whom BT.500 counts: people who passed the screening and finished a sitting.
#include "experiment/store/screened.h"

#include <algorithm>

namespace experiment::store {

namespace {

bool has_passed(const std::vector<Answer>& answers) {
    // A later answer to the same question is the one that counts.
    const auto last = std::find_if(answers.rbegin(), answers.rend(), [](const Answer& answer) {
        return answer.question == "screening";
    });
    return last != answers.rend() && last->answer == "passed";
}

} // namespace

Expected<std::set<protocols::ObserverId>> screened_observers(const VoteStore& store) {
    const auto sittings = store.sittings();
    if (!sittings)
        return tl::unexpected(sittings.error());
    std::set<protocols::ObserverId> screened;
    for (const auto& sitting : *sittings) {
        if (sitting.simulation || !sitting.finished_utc)
            continue;
        const auto answers = store.answers(sitting.key.observer);
        if (!answers)
            return tl::unexpected(answers.error());
        if (has_passed(*answers))
            screened.insert(sitting.key.observer);
    }
    return screened;
}

} // namespace experiment::store
