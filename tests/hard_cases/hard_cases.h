// Cases that are hard on arithmetic: what must come out, what does, and how many digits agree.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace hard_cases {

struct Case {
    std::string area;    ///< the part of the program
    std::string what;    ///< the case
    std::string against; ///< where the expected value comes from
    int values = 0;      ///< how many were compared
    double expected = 0; ///< of the worst of them
    double got = 0;      ///< in the same place
    double digits = 0;   ///< -log10 of the worst error; 17 when all are equal
    double floor = 0;    ///< fewer digits fail the test
};

/// The worst of the values of one case.
class Worst {
  public:
    Worst(std::string area, std::string what, std::string against, double floor)
        : case_{std::move(area), std::move(what), std::move(against), 0, 0, 0, 17, floor} {}

    /// Errors count in units of `size`.  NaN is the worst of all.
    void see(double got, long double expected, long double size) {
        const long double error = std::abs(static_cast<long double>(got) - expected) / size;
        if (case_.values++ == 0 || (!std::isnan(worst_) && !(error <= worst_))) {
            worst_ = error;
            case_.expected = static_cast<double>(expected);
            case_.got = got;
        }
    }

    /// Errors relative to the expected value.
    void see(double got, long double expected) { see(got, expected, std::abs(expected)); }

    Case result() const {
        Case all = case_;
        all.digits = std::isnan(worst_) ? 0
                     : worst_ > 0       ? std::min(17.0, static_cast<double>(-std::log10(worst_)))
                                        : 17;
        return all;
    }

  private:
    Case case_;
    long double worst_ = 0;
};

void add_harmonics(std::vector<Case>& cases);
void add_fits(std::vector<Case>& cases);
void add_rays(std::vector<Case>& cases);
void add_transport(std::vector<Case>& cases);
void add_statistics(std::vector<Case>& cases);

/// Everything there is; takes seconds.
std::vector<Case> measure();

/// The page with these cases, docs/precision-hard-cases.md.
std::string page(const std::vector<Case>& cases);

} // namespace hard_cases
