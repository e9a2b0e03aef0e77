#include "analysis/anova/f_test.h"

#include "analysis/numerics/distributions.h"

#include <cmath>

namespace analysis::anova {

namespace {

FTest without_number(Variation effect, Variation error, Outcome outcome, std::string reason) {
    FTest test;
    test.df1 = effect.df;
    test.df2 = error.df;
    test.outcome = outcome;
    test.reason = std::move(reason);
    return test;
}

} // namespace

FTest f_test(Variation effect, Variation error) {
    if (!(effect.df > 0) || !(error.df > 0))
        return without_number(effect, error, Outcome::Undefined,
                              "no degrees of freedom are left to test with");
    if (error.ss == 0 && effect.ss == 0)
        return without_number(effect, error, Outcome::Undefined,
                              "0/0: neither the effect nor the error varies");
    auto test = without_number(effect, error, Outcome::Computed, {});
    if (error.ss == 0) {
        test.f = std::numeric_limits<double>::infinity();
        test.p = 0;
        test.log10_p = -std::numeric_limits<double>::infinity();
        test.outcome = Outcome::Infinite;
        test.reason = "the error does not vary at all: F is infinite";
        return test;
    }
    test.f = (effect.ss * error.df) / (error.ss * effect.df);
    const auto tail = numerics::f_upper_tail(test.f, effect.df, error.df);
    test.p = tail.p;
    test.log10_p = tail.log10_p;
    return test;
}

double f_test_p(double f, double df1, double df2, double epsilon) {
    return numerics::f_upper_tail(f, df1 * epsilon, df2 * epsilon).p;
}

} // namespace analysis::anova
