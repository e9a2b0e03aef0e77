// The golden experiment: 1,620 votes made by a known process, and every figure computed from them
// in exact arithmetic by another program (tests/data/golden/README.md).
#pragma once

#include "analysis/vote_csv.h"

#include <fstream>
#include <iterator>
#include <string>

inline std::string golden_text(const std::string& path) {
    std::ifstream file(std::string(PAIRLIGHT_TEST_DATA "/golden/") + path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline analysis::VoteTable golden_votes() {
    const std::vector<std::string> order{"SHSS", "Patro", "Green", "PRT"};
    auto votes = analysis::read_votes_csv(golden_text("experiment/votes.csv"), "votes.csv");
    return analysis::with_condition_order(std::move(votes).value(), order).value();
}
