#include "analysis/anova/permutation.h"

#include "analysis/exact.h"
#include "protocols/contract.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace analysis::anova {

namespace {

constexpr double most_arrangements = 2e6;

Wide sum_of_squares(const std::vector<std::int64_t>& totals) {
    Wide sum = 0;
    for (const auto total : totals)
        sum += static_cast<Wide>(total) * total;
    return sum;
}

// SplitMix64 [Steele2014]: a whole stream from one seed, the same on every machine.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    /// Unbiased in 0..bound-1: the few values that would favour small ones are drawn again.
    std::uint64_t below(std::uint64_t bound) {
        const std::uint64_t threshold = (0 - bound) % bound;
        for (;;)
            if (const auto value = next(); value >= threshold)
                return value % bound;
    }

  private:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }

    std::uint64_t state_;
};

using Rows = std::vector<std::vector<std::int64_t>>;

// Every arrangement of the rows from `row` on, added to `totals`.  The first row stays as it is:
// moving all rows together changes nothing.  Places are permuted, not values, so that equal
// scores count as often as they should.
void enumerate(const Rows& rows,
               std::size_t row,
               std::vector<std::int64_t>& totals,
               Wide observed,
               Permutation& result) {
    if (row == rows.size()) {
        ++result.arrangements;
        result.as_large += sum_of_squares(totals) >= observed ? 1 : 0;
        return;
    }
    std::vector<std::size_t> places(totals.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    do {
        for (std::size_t i = 0; i < places.size(); ++i)
            totals[i] += rows[row][places[i]];
        enumerate(rows, row + 1, totals, observed, result);
        for (std::size_t i = 0; i < places.size(); ++i)
            totals[i] -= rows[row][places[i]];
    } while (std::next_permutation(places.begin(), places.end()));
}

void draw(Rows rows, Random random, std::int64_t draws, Wide observed, Permutation& result) {
    result.arrangements = result.as_large = 1; // the observed one
    for (std::int64_t d = 0; d < draws; ++d) {
        std::vector<std::int64_t> totals(rows[0].size());
        for (auto& row : rows) {
            for (auto i = row.size(); i > 1; --i)
                std::swap(row[i - 1], row[random.below(i)]);
            for (std::size_t i = 0; i < row.size(); ++i)
                totals[i] += row[i];
        }
        ++result.arrangements;
        result.as_large += sum_of_squares(totals) >= observed ? 1 : 0;
    }
}

} // namespace

Permutation permute_labels(std::span<const std::int64_t> counts,
                           std::size_t levels,
                           std::uint64_t seed,
                           std::int64_t draws) {
    EXPECTS(levels >= 2 && counts.size() % levels == 0 && counts.size() >= 2 * levels && draws > 0);
    Rows rows;
    std::vector<std::int64_t> totals(levels);
    for (std::size_t at = 0; at < counts.size(); at += levels) {
        rows.emplace_back(counts.begin() + static_cast<std::ptrdiff_t>(at),
                          counts.begin() + static_cast<std::ptrdiff_t>(at + levels));
        for (std::size_t i = 0; i < levels; ++i)
            totals[i] += rows.back()[i];
        EXPECTS(std::accumulate(rows.back().begin(), rows.back().end(), std::int64_t{0}) ==
                std::accumulate(rows[0].begin(), rows[0].end(), std::int64_t{0}));
    }
    const auto observed = sum_of_squares(totals);
    double arrangements = 1;
    for (std::size_t row = 1; row < rows.size(); ++row)
        for (std::size_t i = 2; i <= levels; ++i)
            arrangements *= static_cast<double>(i);
    Permutation result;
    result.complete = arrangements <= most_arrangements;
    if (result.complete) {
        totals = rows[0];
        enumerate(rows, 1, totals, observed, result);
    } else {
        draw(std::move(rows), Random(seed), draws, observed, result);
    }
    result.p = to_double({result.as_large, result.arrangements});
    return result;
}

} // namespace analysis::anova
