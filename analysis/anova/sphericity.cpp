#include "analysis/anova/sphericity.h"

#include "analysis/numerics/distributions.h"
#include "protocols/contract.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <map>

namespace analysis::anova {

namespace {

struct Covariance {
    Eigen::MatrixXd matrix;
    double df = 0; // observers less groups
};

Covariance
pooled_covariance(std::span<const double> scores, std::span<const int> groups, Eigen::Index p) {
    const auto n = static_cast<Eigen::Index>(groups.size());
    Eigen::MatrixXd centred =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            scores.data(), n, p);
    std::map<int, std::vector<Eigen::Index>> members;
    for (Eigen::Index o = 0; o < n; ++o)
        members[groups[static_cast<std::size_t>(o)]].push_back(o);
    for (const auto& [group, rows] : members) {
        Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(p);
        for (const auto row : rows)
            mean += centred.row(row);
        mean /= static_cast<double>(rows.size());
        for (const auto row : rows)
            centred.row(row) -= mean;
    }
    const auto df = static_cast<double>(n) - static_cast<double>(members.size());
    return {centred.transpose() * centred / df, df};
}

// Box's second term: `columns` is p where the theory stands, the raw columns where R does.
double second_order(double p, double columns, double nu, double rho, double tail, double tail4) {
    const double w2 = (p + 2) * (p - 1) * (p - 2) * (2 * p * p * p + 6 * p * p + 3 * columns + 2) /
                      (288 * (nu * p * rho) * (nu * p * rho));
    return tail + w2 * (tail4 - tail);
}

void mauchly(Sphericity& result, const Covariance& covariance, double p, double raw_columns) {
    const double nu = covariance.df;
    if (nu < p) {
        result.reason = "Mauchly's test needs at least as many observers, less groups, as the "
                        "effect has degrees of freedom";
        return;
    }
    const Eigen::LDLT<Eigen::MatrixXd> factors(covariance.matrix);
    const double mean = covariance.matrix.trace() / p;
    double log_w = 0;
    for (const double pivot : factors.vectorD())
        log_w += std::log(std::max(pivot, 0.0) / mean);
    result.mauchly_w = std::exp(log_w);
    const double rho = 1 - (2 * p * p + p + 2) / (6 * p * nu);
    result.chi_squared = -nu * rho * log_w;
    result.df = p * (p + 1) / 2 - 1;
    if (!std::isfinite(result.chi_squared)) {
        result.reason = "the contrasts are linearly dependent: Mauchly's W is 0";
        return;
    }
    const double x = std::max(result.chi_squared, 0.0);
    const double tail = numerics::chi_squared_upper_tail(x, result.df).p;
    const double tail4 = numerics::chi_squared_upper_tail(x, result.df + 4).p;
    result.p_chi_squared = tail;
    result.p_second_order = second_order(p, p, nu, rho, tail, tail4);
    result.p_as_r = second_order(p, raw_columns, nu, rho, tail, tail4);
}

} // namespace

Sphericity sphericity(std::span<const double> contrast_scores,
                      std::span<const int> groups,
                      std::size_t contrasts,
                      std::size_t raw_columns,
                      const FTest& effect) {
    EXPECTS(contrasts > 0 && contrast_scores.size() == groups.size() * contrasts);
    Sphericity result;
    const auto p = static_cast<double>(contrasts);
    if (contrasts == 1) {
        result.reason = "two levels: there is one difference, so there is nothing to compare";
        return result;
    }
    const auto covariance =
        pooled_covariance(contrast_scores, groups, static_cast<Eigen::Index>(contrasts));
    const double trace = covariance.matrix.trace();
    if (effect.outcome != Outcome::Computed || !(trace > 0)) {
        result.reason = "the contrasts do not vary between observers";
        return result;
    }
    mauchly(result, covariance, p, static_cast<double>(raw_columns));
    const double nu = covariance.df;
    const double gg = trace * trace / (p * covariance.matrix.squaredNorm());
    result.greenhouse_geisser = gg;
    result.huynh_feldt_raw = ((nu + 1) * p * gg - 2) / (p * (nu - p * gg));
    // The estimate's denominator passes through zero when there are hardly more observers than
    // contrasts; it means "no correction" then, as values above 1 do.
    result.huynh_feldt = result.huynh_feldt_raw > 0 ? std::min(1.0, result.huynh_feldt_raw) : 1.0;
    result.lower_bound = 1 / p;
    result.p_greenhouse_geisser = f_test_p(effect.f, effect.df1, effect.df2, gg);
    result.p_huynh_feldt = result.huynh_feldt == 1.0
                               ? effect.p
                               : f_test_p(effect.f, effect.df1, effect.df2, result.huynh_feldt);
    result.p_lower_bound = f_test_p(effect.f, effect.df1, effect.df2, result.lower_bound);
    return result;
}

} // namespace analysis::anova
