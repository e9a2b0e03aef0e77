// Does an observer answer alike in another session, do two observers answer alike, and does the
// left side win?
#pragma once

#include "analysis/vote_table.h"

#include <cstdint>
#include <string>
#include <vector>

namespace analysis::consistency {

/// Shares of identical answers to the same scene and pair; NaN where nothing was answered twice.
struct SessionPair {
    std::string first;
    std::string second;
    double share = 0;
};

struct ObserverRepeatability {
    std::string observer;
    std::vector<SessionPair> sessions;
    double mean = 0;             ///< over pairs of sessions that share questions
    double chance_corrected = 0; ///< 2 mean - 1: 0 for coin tossing, in a forced choice
};

struct ObserverPair {
    std::string first;
    std::string second;
    double share = 0; ///< over the questions both answered in the same session
};

struct Repeatability {
    std::vector<ObserverRepeatability> within;
    std::vector<ObserverPair> between;
    double within_mean = 0;  ///< over observers
    double between_mean = 0; ///< over pairs of observers
};

/// Where a question was answered more than once in a session, its first answer counts.
Repeatability repeatability(const VoteTable& table);

struct SideBias {
    std::int64_t left = 0;    ///< answers "left"
    std::int64_t answers = 0; ///< without ties
    double z = 0;
    double p = 0; ///< exact binomial, two-sided: twice the smaller tail
};

SideBias side_bias(std::int64_t left, std::int64_t answers);
SideBias side_bias(const VoteTable& table);

} // namespace analysis::consistency
