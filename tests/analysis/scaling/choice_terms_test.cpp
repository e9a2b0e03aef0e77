#include "analysis/scaling/choice_terms.h"

#include <cmath>
#include <limits>

namespace {

using namespace analysis::scaling;

// The best of central differences over many steps: too long a step curves, too short a one rounds.
template <class F>
double best_difference_error(F f, double x, double derivative) {
    double best = std::numeric_limits<double>::infinity();
    for (double h = 0.1; h > 1e-7; h /= 3)
        best = std::min(best, std::abs((f(x + h) - f(x - h)) / (2 * h) - derivative));
    return best;
}

TEST(ChoiceTerms, SlopesAndCurvaturesAreDerivatives) {
    for (const double d : {-6.0, -1.001, -0.999, -0.2, 0.0, 0.7, 1.5, 5.0})
        for (const auto term : {logit_term, probit_term}) {
            const auto at = term(d, 12, 5);
            const auto value = [&](double x) { return term(x, 12, 5).log_likelihood; };
            const auto slope = [&](double x) { return term(x, 12, 5).slope; };
            const double scale = 1 + std::abs(at.log_likelihood);
            EXPECT_LE(best_difference_error(value, d, at.slope), 1e-9 * scale) << d;
            EXPECT_LE(best_difference_error(slope, d, -at.curvature), 1e-9 * scale) << d;
        }
}

TEST(ChoiceTerms, OfDavidsonAreDerivatives) {
    for (const double d : {-4.0, -0.3, 0.0, 2.0})
        for (const double nu : {-3.0, 0.0, 1.5}) {
            const auto at = davidson_term(d, nu, 7, 4, 3);
            const auto along_d = [&](auto member) {
                return [=](double x) { return davidson_term(x, nu, 7, 4, 3).*member; };
            };
            const auto along_nu = [&](auto member) {
                return [=](double x) { return davidson_term(d, x, 7, 4, 3).*member; };
            };
            using Term = TiedPairTerm;
            EXPECT_LE(best_difference_error(along_d(&Term::log_likelihood), d, at.slope), 1e-8);
            EXPECT_LE(best_difference_error(along_nu(&Term::log_likelihood), nu, at.slope_nu),
                      1e-8);
            EXPECT_LE(best_difference_error(along_d(&Term::slope), d, -at.curvature), 1e-8);
            EXPECT_LE(best_difference_error(along_nu(&Term::slope), nu, -at.curvature_cross), 1e-8);
            EXPECT_LE(best_difference_error(along_d(&Term::slope_nu), d, -at.curvature_cross),
                      1e-8);
            EXPECT_LE(best_difference_error(along_nu(&Term::slope_nu), nu, -at.curvature_nu), 1e-8);
        }
}

TEST(ChoiceTerms, AreContinuousWhereTheirFormsChange) {
    for (const double at : {1.0, -1.0, 8.0, -8.0})
        for (const auto term : {logit_term, probit_term}) {
            const double inside = at * (1 - 1e-15), outside = at * (1 + 1e-15);
            const auto a = term(inside, 9, 4), b = term(outside, 9, 4);
            EXPECT_NEAR(a.slope / b.slope, 1, 1e-12) << at;
            EXPECT_NEAR(a.log_likelihood / b.log_likelihood, 1, 1e-12) << at;
            // 8 deviations out the curvature is a difference of figures that agree to 1 / 64.
            EXPECT_NEAR(a.curvature / b.curvature, 1, 1e-11) << at;
        }
}

TEST(ChoiceTerms, StayFiniteFarOut) {
    EXPECT_DOUBLE_EQ(logit_term(-800, 1, 0).log_likelihood, -800);
    EXPECT_EQ(logit_term(-800, 1, 0).slope, 1);
    EXPECT_NEAR(probit_term(-1000, 1, 0).log_likelihood, -500007.82669481216, 1e-9);
    EXPECT_NEAR(probit_term(-1000, 1, 0).slope, 1000.001, 1e-6);
    EXPECT_EQ(logit_term(-800, 0, 0).log_likelihood, 0);
    EXPECT_NEAR(davidson_term(-1500, 0, 1, 0, 0).log_likelihood, -1500, 1e-9);
}

TEST(ChoiceTerms, ProbabilitiesAddUpToOne) {
    for (const double d : {-3.0, 0.0, 0.4, 6.0})
        for (const auto link : {Link::Logit, Link::Probit})
            EXPECT_NEAR(choice_probability(link, d) + choice_probability(link, -d), 1, 1e-15);
    EXPECT_NEAR(choice_probability(Link::Logit, 1), 0.7310585786300049, 1e-15);
}

} // namespace
