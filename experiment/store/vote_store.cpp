// What any vote store needs.
#include "experiment/store/vote_store.h"

#include "experiment/store/words.h"
#include "protocols/digest.h"

#include <fmt/format.h>

#include <algorithm>

namespace experiment::store {

bool is_pseudonym(const std::string& id) {
    return !id.empty() && id.size() <= 32 && std::ranges::all_of(id, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '-' || c == '_';
    });
}

std::string plan_digest(std::span<const protocols::PlannedTrial> plan) {
    std::string text;
    for (const auto& [number, phase, trial] : plan)
        text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\n", number, word_of(phase), trial.scene.value,
                            trial.variant.value, trial.left.value, trial.right.value);
    return protocols::sha256_hexadecimal(text);
}

} // namespace experiment::store
