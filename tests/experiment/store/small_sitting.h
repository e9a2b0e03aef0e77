// A sitting of one training trial, one warm-up and three main trials, as it comes to the store.
#pragma once

#include "experiment/store/vote_store.h"

#include <string>
#include <vector>

namespace tests {

inline const experiment::store::StudyIdentity study{"glow", std::string(64, 'a')};

inline experiment::store::SittingKey sitting_of(const std::string& observer, int session = 1) {
    return {{observer}, session};
}

inline std::vector<protocols::PlannedTrial> small_plan() {
    using protocols::Phase;
    return {{1, Phase::Training, {{"sphere"}, {"back"}, {"green"}, {"phong"}}},
            {2, Phase::WarmUp, {{"torus"}, {"left"}, {"shss"}, {"phong"}}},
            {3, Phase::Main, {{"torus"}, {"back"}, {"shss"}, {"green"}}},
            {4, Phase::Main, {{"bunny"}, {"back"}, {"phong"}, {"shss"}}},
            {5, Phase::Main, {{"torus"}, {"left"}, {"green"}, {"phong"}}}};
}

inline experiment::store::SittingStart start_of(const experiment::store::SittingKey& key) {
    experiment::store::SittingStart start;
    start.key = key;
    start.study_sha256 = study.file_sha256;
    start.local_date = "2026-03-01";
    start.started_utc = "2026-03-01T09:00:00.000Z";
    start.generator = "pcg64";
    start.order_seed = "0123";
    start.sides_seed = "4567";
    start.scene_rule = "no two neighbours share a scene";
    start.plan_sha256 = experiment::store::plan_digest(small_plan());
    start.renderer = "llvmpipe";
    start.display = "resolution=1280x800";
    start.timing_grade = "U";
    return start;
}

inline experiment::store::Shown shown(int trial, int presentation = 1) {
    return {
        trial, presentation, trial * 1'000'000'000LL, "swap_return", "2026-03-01T09:00:01.000Z", 5,
        0};
}

inline experiment::store::MainVote vote(int trial, protocols::Choice chosen) {
    return {trial,
            chosen,
            std::chrono::milliseconds(1234),
            trial * 1'000'000'000LL,
            trial * 1'000'000'000LL + 1'234'000'000LL,
            "2026-03-01T09:00:01.000Z",
            "keyboard",
            "left",
            2,
            true};
}

} // namespace tests
