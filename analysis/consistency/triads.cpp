#include "analysis/consistency/triads.h"

#include <limits>

namespace analysis::consistency {

std::int64_t most_triads(std::int64_t t) {
    return (t * t * t - (t % 2 == 0 ? 4 : 1) * t) / 24;
}

double expected_triads(std::int64_t t) {
    return static_cast<double>(t * (t - 1) * (t - 2)) / 24;
}

double triads_variance(std::int64_t t) {
    return static_cast<double>(t * (t - 1) * (t - 2)) / 32;
}

namespace {

// i beats j, j beats k, k beats i.
bool cycle(const VoteMatrix& round, std::size_t i, std::size_t j, std::size_t k) {
    return round.wins(i, j) > 0 && round.wins(j, k) > 0 && round.wins(k, i) > 0;
}

} // namespace

std::optional<std::int64_t> circular_triads(const VoteMatrix& round) {
    if (round.complete() != 1)
        return std::nullopt;
    const auto t = static_cast<std::int64_t>(round.conditions());
    if (round.total_ties() == 0) {
        std::int64_t squares = 0; // of scores, each from 0 to t - 1
        for (std::size_t i = 0; i < round.conditions(); ++i)
            squares += round.half_votes(i) / 2 * (round.half_votes(i) / 2);
        return (t * (t - 1) * (2 * t - 1) / 6 - squares) / 2;
    }
    std::int64_t triads = 0;
    for (std::size_t i = 0; i < round.conditions(); ++i)
        for (std::size_t j = i + 1; j < round.conditions(); ++j)
            for (std::size_t k = j + 1; k < round.conditions(); ++k)
                triads += cycle(round, i, j, k) || cycle(round, i, k, j) ? 1 : 0;
    return triads;
}

double zeta(std::int64_t triads, std::int64_t conditions) {
    if (most_triads(conditions) == 0)
        return std::numeric_limits<double>::quiet_NaN();
    return to_double({most_triads(conditions) - triads, most_triads(conditions)});
}

} // namespace analysis::consistency
