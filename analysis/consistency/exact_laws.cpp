#include "analysis/consistency/exact_laws.h"

#include "analysis/consistency/triads.h"
#include "analysis/numerics/distributions.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace analysis::consistency {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

// How many of the 2^(t(t-1)/2) tournaments have 0, 1, 2.. circular triads, by enumeration.
const std::vector<double>& tournaments(std::int64_t t) {
    static const std::vector<double> counts[] = {
        {6, 2},
        {24, 16, 24},
        {120, 120, 240, 240, 280, 24},
        {720, 960, 2240, 2880, 6240, 3648, 8640, 4800, 2640},
        {5040, 8400, 21840, 33600, 75600, 90384, 179760, 188160, 277200, 280560, 384048, 244160,
         233520, 72240, 2640}};
    return counts[t - 3];
}

double exact_triads_p(std::int64_t triads, std::int64_t rounds, std::int64_t t) {
    const auto& counts = tournaments(t);
    const auto pairs = static_cast<int>(t * (t - 1) / 2);
    std::vector<double> law{1};
    for (std::int64_t round = 0; round < rounds; ++round) {
        std::vector<double> next(
            std::min(law.size() + counts.size() - 1, static_cast<std::size_t>(triads) + 1));
        for (std::size_t a = 0; a < law.size(); ++a)
            for (std::size_t b = 0; b < counts.size() && a + b < next.size(); ++b)
                next[a + b] += std::ldexp(law[a] * counts[b], -pairs);
        law = std::move(next);
    }
    double p = 0;
    for (const double probability : law)
        p += probability;
    return std::min(p, 1.0);
}

// [KendallBabingtonSmith1940]: a linear function of the triads is nearly chi-squared.
double one_large_round_p(std::int64_t triads, std::int64_t conditions) {
    const auto t = static_cast<double>(conditions);
    const double df = t * (t - 1) * (t - 2) / ((t - 4) * (t - 4));
    const double chi_squared =
        8 / (t - 4) * (expected_triads(conditions) - static_cast<double>(triads) + 0.5) + df;
    return numerics::chi_squared_upper_tail(std::max(chi_squared, 0.0), df).p;
}

std::vector<long double> binomial_half(std::int64_t n) {
    std::vector<long double> p{std::ldexp(1.0L, static_cast<int>(-n))};
    for (std::int64_t x = 0; x < n; ++x)
        p.push_back(p.back() * static_cast<long double>(n - x) / static_cast<long double>(x + 1));
    return p;
}

} // namespace

double triads_p(std::int64_t triads, std::int64_t rounds, std::int64_t conditions) {
    EXPECTS(triads >= 0 && rounds >= 0);
    if (conditions < 3 || rounds == 0)
        return undefined;
    if (conditions <= 7)
        return exact_triads_p(triads, rounds, conditions);
    if (rounds == 1)
        return one_large_round_p(triads, conditions);
    const auto n = static_cast<double>(rounds);
    const double z = (static_cast<double>(triads) + 0.5 - n * expected_triads(conditions)) /
                     std::sqrt(n * triads_variance(conditions));
    return numerics::normal_upper_tail(-z).p;
}

// States are the totals of all conditions but the last, which follows from their sum.
std::optional<double>
range_p_exact(std::int64_t range, std::int64_t votes, std::int64_t conditions) {
    EXPECTS(range >= 0 && votes >= 1 && conditions >= 2);
    if (conditions > 4 || votes > 20)
        return std::nullopt;
    const auto t = static_cast<std::size_t>(conditions), free = t - 1;
    const auto side = static_cast<std::size_t>(votes) * free + 1; // totals 0..(t-1) m
    std::size_t states = 1;
    std::vector<std::size_t> stride(t, 0);
    for (std::size_t i = 0; i < free; ++i) {
        stride[i] = states;
        states *= side;
    }
    const auto outcome = binomial_half(votes);
    std::vector<long double> law(states, 0), next(states);
    law[0] = 1;
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = i + 1; j < t; ++j) {
            std::fill(next.begin(), next.end(), 0.0L);
            for (std::size_t state = 0; state < states; ++state)
                if (law[state] > 0)
                    for (std::size_t x = 0; x < outcome.size(); ++x)
                        next[state + x * stride[i] + (outcome.size() - 1 - x) * stride[j]] +=
                            law[state] * outcome[x];
            std::swap(law, next);
        }
    long double p = 0;
    for (std::size_t state = 0; state < states; ++state) {
        auto last = static_cast<std::int64_t>(t * free / 2) * votes, low = last, high = last;
        high = 0;
        for (std::size_t i = 0; i < free; ++i) {
            const auto total = static_cast<std::int64_t>(state / stride[i] % side);
            last -= total;
            low = std::min(low, total);
            high = std::max(high, total);
        }
        if (std::max(high, last) - std::min(low, last) >= range)
            p += law[state];
    }
    return static_cast<double>(std::min(p, 1.0L));
}

// Probability of still being without such a run, by the length of the run under way.
double longest_run_p(std::int64_t length, std::int64_t answers) {
    EXPECTS(length >= 1 && answers >= 0);
    if (length > answers)
        return 0;
    if (length == 1)
        return 1;
    std::vector<double> run(static_cast<std::size_t>(length), 0); // [r]: a run of r, r < length
    run[1] = 1;
    double reached = 0;
    for (std::int64_t answer = 1; answer < answers; ++answer) {
        double all = 0;
        for (const double p : run)
            all += p;
        reached += run.back() / 2;
        for (std::size_t r = run.size() - 1; r > 1; --r)
            run[r] = run[r - 1] / 2;
        run[1] = all / 2;
    }
    return std::min(reached, 1.0);
}

} // namespace analysis::consistency
