// x of m judges agree one way on a pair: it has C(m,2) - x (m - x) agreeing pairs of judges, so
// Sigma is large when the sum of x (m - x) is small, and its law is a sum of small terms.
#include "analysis/consistency/agreement_exact.h"

#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace analysis::consistency {

namespace {

constexpr double most_multiplications = 2e7;

struct Step {
    std::size_t disagreeing = 0; ///< pairs of judges
    long double probability = 0;
};

std::vector<Step> law_of_one_pair(std::int64_t m) {
    std::vector<Step> steps;
    long double probability = std::ldexp(1.0L, static_cast<int>(1 - m)); // x = 0 or m
    for (std::int64_t x = 0; 2 * x <= m; ++x) {
        const bool middle = 2 * x == m;
        steps.push_back(
            {static_cast<std::size_t>(x * (m - x)), middle ? probability / 2 : probability});
        probability *= static_cast<long double>(m - x) / static_cast<long double>(x + 1);
    }
    return steps;
}

} // namespace

std::optional<double>
agreement_p_exact(std::int64_t sigma, std::int64_t judges, std::int64_t conditions) {
    EXPECTS(judges >= 2 && conditions >= 2);
    if (judges > 10'000 || conditions > 10'000)
        return std::nullopt;
    const auto pairs = conditions * (conditions - 1) / 2;
    const auto all = pairs * (judges * (judges - 1) / 2);
    const auto most = pairs * (judges / 2) * (judges - judges / 2); // disagreeing pairs of judges
    if (sigma > all)
        return 0;
    const auto limit = std::min(all - sigma, most);
    const double work = static_cast<double>(pairs) * static_cast<double>(judges / 2 + 1) *
                        static_cast<double>(limit + 1);
    if (!(work <= most_multiplications))
        return std::nullopt;
    const auto size = static_cast<std::size_t>(limit + 1);
    const auto steps = law_of_one_pair(judges);
    std::vector<long double> law(size, 0), next(size);
    law[0] = 1;
    for (std::int64_t pair = 0; pair < pairs; ++pair) {
        std::fill(next.begin(), next.end(), 0.0L);
        for (const auto& step : steps)
            for (std::size_t d = 0; d + step.disagreeing < size; ++d)
                next[d + step.disagreeing] += law[d] * step.probability;
        std::swap(law, next);
    }
    long double tail = 0;
    for (const auto probability : law)
        tail += probability;
    return static_cast<double>(std::min(tail, 1.0L));
}

} // namespace analysis::consistency
