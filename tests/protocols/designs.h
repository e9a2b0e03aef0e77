// Studies to test with: so many scenes, variants and conditions, named by letter and number.
#pragma once

#include "protocols/study.h"

#include <string>

namespace tests {

/// Scenes s0.., variants v0.. (none when `variants` is 0) and conditions c0...
inline protocols::Study design(int scenes, int variants, int conditions, int repetitions = 1) {
    protocols::Study study;
    study.id = "design";
    study.seed = 7;
    study.plan.repetitions = repetitions;
    for (int i = 0; i < scenes; ++i)
        study.scenes.emplace_back().id.value = "s" + std::to_string(i);
    for (int i = 0; i < variants; ++i)
        study.variants.emplace_back().id.value = "v" + std::to_string(i);
    for (int i = 0; i < conditions; ++i) {
        auto& condition = study.conditions.emplace_back();
        condition.id.value = "c" + std::to_string(i);
        condition.source = protocols::OwnImages{};
    }
    return study;
}

} // namespace tests
