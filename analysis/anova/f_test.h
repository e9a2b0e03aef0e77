// One F ratio, and what can be said when it is not a number.
#pragma once

#include <limits>
#include <string>

namespace analysis::anova {

inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// How far a test could be carried out.
enum class Outcome {
    Computed,
    Infinite,   ///< no error variation at all, and some effect: F is infinite, p is 0
    Ipsative,   ///< scores of every round sum to a constant, so this effect cannot vary
    Undefined,  ///< 0/0
    NotComputed ///< the design does not allow it; the reason says why
};

/// A sum of squares on its degrees of freedom; `ss` is 0 only when surely 0.
struct Variation {
    double ss = 0;
    double df = 0;

    double ms() const { return ss / df; }
};

/// `f`, `p` and `log10_p` are NaN when undefined; then `reason` says why.
struct FTest {
    double f = undefined;
    double df1 = undefined;
    double df2 = undefined;
    double p = undefined;
    double log10_p = undefined;
    Outcome outcome = Outcome::NotComputed;
    std::string reason;
};

/// Upper-tail F test of one variation against another.
FTest f_test(Variation effect, Variation error);

/// The same F with both degrees of freedom multiplied by `epsilon`: p only.
double f_test_p(double f, double df1, double df2, double epsilon);

} // namespace analysis::anova
