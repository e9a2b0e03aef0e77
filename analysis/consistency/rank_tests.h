// Tests on ranks within observers: Friedman, Kendall's W, Iman and Davenport's F, Nemenyi's pairs.
// [Friedman1937], [ImanDavenport1980], [Nemenyi1963]
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace analysis::consistency {

struct RankTest {
    std::size_t blocks = 0; ///< observers
    std::size_t conditions = 0;
    std::vector<double> rank_sums; ///< the best score has the highest rank; ties share mid-ranks
    double chi_squared = 0;
    double df = 0;
    double p = 0;
    double kendall_w = 0; ///< 0 no agreement .. 1 all rank alike
    double f = 0;         ///< NaN when W is 1
    double p_f = 0;
    std::string reason; ///< why something is NaN
};

/// `scores` is row-major blocks x conditions.
RankTest friedman(std::span<const std::int64_t> scores, std::size_t conditions);

struct RankPair {
    std::size_t first = 0;
    std::size_t second = 0;
    double mean_rank_difference = 0;
    double q = 0;
    double p = 0;
};

struct Nemenyi {
    double critical_difference = 0; ///< of mean ranks at `level`
    std::vector<RankPair> pairs;
};

Nemenyi nemenyi(const RankTest& ranks, double level = 0.05);

} // namespace analysis::consistency
