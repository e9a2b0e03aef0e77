// A fit against a golden one.
#pragma once

#include "analysis/scaling/choice_fit.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace golden {

// Relative to the largest of its kind: a score that is 0 by symmetry has no digits of its own.
inline void expect_all_near(const std::vector<double>& values,
                            const std::vector<double>& expected,
                            double tolerance,
                            const std::string& what) {
    ASSERT_EQ(values.size(), expected.size()) << what;
    double largest = 0;
    for (const double value : expected)
        largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(values[i], expected[i], tolerance * largest) << what << ' ' << i;
}

/// theta, standard errors, covariance (where the golden has it) and log-likelihood.
inline void expect_fit(const analysis::scaling::ChoiceFit& fit,
                       const nlohmann::json& expected,
                       double tolerance,
                       const std::string& what) {
    using Doubles = std::vector<double>;
    ASSERT_TRUE(fit.converged) << what << ": " << fit.reason;
    expect_all_near(fit.theta, expected.at("theta_centered").get<Doubles>(), tolerance,
                    what + " theta");
    Doubles errors;
    for (std::size_t i = 0; i < fit.conditions(); ++i)
        errors.push_back(analysis::scaling::standard_error(fit, i));
    expect_all_near(errors, expected.at("se_centered").get<Doubles>(), tolerance, what + " se");
    if (expected.contains("cov_centered")) {
        Doubles covariance;
        for (const auto& row : expected.at("cov_centered"))
            for (const auto& value : row)
                covariance.push_back(value.get<double>());
        expect_all_near(fit.covariance, covariance, tolerance, what + " covariance");
    }
    const double log_likelihood = expected.at("loglik").get<double>();
    EXPECT_NEAR(fit.log_likelihood, log_likelihood, tolerance * std::abs(log_likelihood)) << what;
}

} // namespace golden
