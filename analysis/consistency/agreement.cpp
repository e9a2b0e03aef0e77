#include "analysis/consistency/agreement.h"

#include "analysis/consistency/agreement_exact.h"
#include "analysis/numerics/distributions.h"

#include <algorithm>
#include <limits>

namespace analysis::consistency {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

double chi_squared_p(double x, double df) {
    return numerics::chi_squared_upper_tail(std::max(x, 0.0), df).p;
}

void tests(Agreement& result) {
    const auto m = static_cast<double>(result.judges);
    const auto t = static_cast<double>(result.conditions);
    const double pairs = t * (t - 1) / 2;
    const double expected = pairs * (m * (m - 1) / 2) * (m - 3) / (2 * (m - 2));
    result.df = pairs * m * (m - 1) / ((m - 2) * (m - 2));
    result.chi_squared = 4 / (m - 2) * (result.agreeing_pairs - expected);
    result.chi_squared_corrected = 4 / (m - 2) * (result.agreeing_pairs - 1 - expected);
    result.p = chi_squared_p(result.chi_squared, result.df);
    result.p_corrected = chi_squared_p(result.chi_squared_corrected, result.df);
}

} // namespace

Agreement agreement(const VoteMatrix& matrix) {
    const auto t = static_cast<std::int64_t>(matrix.conditions());
    const auto m = matrix.complete();
    Agreement result{t,         m,         undefined, undefined, undefined,
                     undefined, undefined, undefined, undefined, undefined,
                     undefined, undefined, undefined, undefined, {}};
    if (m < 2 || matrix.total_ties() > 0) {
        result.reason = m == 0   ? "the pairs were not judged equally often"
                        : m == 1 ? "there is one judge"
                                 : "u is for forced choices, and there are ties";
        return result;
    }
    Wide agreeing = 0; // 128 bits: m of 1e9 squares beyond 64
    for (std::size_t i = 0; i < matrix.conditions(); ++i)
        for (std::size_t j = 0; j < matrix.conditions(); ++j)
            if (i != j) {
                const Wide wins = matrix.wins(i, j);
                agreeing += wins * (wins - 1) / 2;
            }
    // u = (2 agreeing - all) / all with all = C(m,2) C(t,2): the difference is formed in integers
    const Wide all = static_cast<Wide>(m) * (m - 1) / 2 * (t * (t - 1) / 2);
    result.agreeing_pairs = static_cast<double>(agreeing);
    result.u = static_cast<double>(2 * agreeing - all) / static_cast<double>(all);
    result.u_min = -1 / static_cast<double>(m % 2 == 0 ? m - 1 : m);
    const double pairs = static_cast<double>(t * (t - 1)) / 2;
    result.df_many = pairs;
    result.chi_squared_many = pairs * (1 + result.u * static_cast<double>(m - 1));
    result.p_many = chi_squared_p(result.chi_squared_many, pairs);
    if (agreeing <= std::numeric_limits<std::int64_t>::max())
        result.p_exact =
            agreement_p_exact(static_cast<std::int64_t>(agreeing), m, t).value_or(undefined);
    if (m == 2)
        result.reason =
            "two judges: the chi-squared of u has a zero denominator; its exact p stands";
    else
        tests(result);
    return result;
}

} // namespace analysis::consistency
