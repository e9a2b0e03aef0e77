// NIST's sets and the far tails of distributions, where these have a closed form.
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/nist_file.h"
#include "analysis/numerics/one_way_exact.h"
#include "analysis/numerics/studentized_range.h"
#include "tests/analysis/numerics/golden_table.h"
#include "tests/hard_cases/hard_cases.h"

#include <limits>
#include <numbers>

namespace hard_cases {

namespace {

using namespace analysis::numerics;

const std::string area = "tails";
const std::string closed = "closed form in 64 bits";
constexpr double infinity = std::numeric_limits<double>::infinity();

Case nist() {
    Worst worst("NIST", "F of all eleven sets of one-way variance", "exact rational arithmetic",
                14.5);
    const golden::Table table("nist_exact.csv");
    for (std::size_t i = 0; i < table.rows(); ++i) {
        if (table.text(i, "input") != "decimal")
            continue;
        const auto set = table.text(i, "set");
        std::ifstream file(PAIRLIGHT_TEST_DATA "/nist/" + set + ".dat");
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        worst.see(one_way_exact(read_nist_one_way(text, set).value().groups).f,
                  table.number(i, "F"));
    }
    return worst.result();
}

long double normal_tail(long double z) {
    return std::erfc(z / std::numbers::sqrt2_v<long double>) / 2;
}

Case normal() {
    Worst worst(area, "normal, z from -5 to 37", "error function in 64 bits", 13);
    for (int z = -5; z <= 37; ++z)
        worst.see(normal_upper_tail(z).p, normal_tail(z));
    return worst.result();
}

/// log10 of phi(z)/z (1 - 1/z^2 + 3/z^4 - 15/z^6): from z = 1000 on the next term is 1e-22.
Case normal_beyond_doubles() {
    Worst worst(area, "normal beyond the range of doubles, z to 1e8, its logarithm",
                "asymptotic series", 14);
    for (const long double z : {1e3L, 1e4L, 1e6L, 1e8L}) {
        const long double q = 1 / (z * z);
        const long double natural = -z * z / 2 - std::log(z) -
                                    std::log(2 * std::numbers::pi_v<long double>) / 2 +
                                    std::log1p(-q * (1 - q * (3 - 15 * q)));
        worst.see(normal_upper_tail(static_cast<double>(z)).log10_p,
                  natural / std::numbers::ln10_v<long double>);
    }
    return worst.result();
}

Case quantiles() {
    Worst worst(area, "normal quantiles to p = 1e-300, put back into the tail", "p itself", 11);
    for (const double p : {0.25, 1e-3, 1e-10, 1e-50, 1e-100, 1e-200, 1e-300})
        worst.see(static_cast<double>(normal_tail(-static_cast<long double>(normal_quantile(p)))),
                  static_cast<long double>(p));
    return worst.result();
}

/// Two degrees of freedom: (1 - t / sqrt(2 + t^2)) / 2, without the cancellation.
long double t_tail_of_two(long double t) {
    const long double root = std::sqrt(2 + t * t);
    return 1 / (root * (root + t));
}

Case student() {
    Worst worst(area, "t with 1 and 2 degrees of freedom, t from 1e-8 to 1e150", closed, 13);
    for (const double t : {1e-8, 1e-3, 1.0, 30.0, 1e4, 1e8, 1e100, 1e150}) {
        worst.see(t_upper_tail(t, 1).p,
                  std::atan(1 / static_cast<long double>(t)) / std::numbers::pi_v<long double>);
        worst.see(t_upper_tail(t, 2).p, t_tail_of_two(t));
    }
    return worst.result();
}

/// Two degrees of freedom above: (1 + 2F/n)^(-n/2).
Case fisher() {
    Worst worst(area, "F with 2 and 1 to 1e6 degrees of freedom, F from 1e-8 to 1e8", closed, 12);
    for (const double n : {1.0, 3.0, 27.0, 1000.0, 1e6})
        for (const double f : {1e-8, 1e-3, 1.0, 20.0, 600.0, 1e5, 1e8}) {
            const long double exact =
                -static_cast<long double>(n) / 2 * std::log1p(2 * static_cast<long double>(f) / n);
            const auto tail = f_upper_tail(f, 2, n);
            if (exact > -600)
                worst.see(tail.p, std::exp(exact));
            else
                worst.see(tail.log10_p, exact / std::numbers::ln10_v<long double>);
        }
    return worst.result();
}

Case chi_squared() {
    Worst worst(area, "chi-squared with 2 degrees of freedom, to 1e6", closed, 13);
    for (const double x : {1e-10, 1.0, 100.0, 1400.0, 1e4, 1e6}) {
        const auto tail = chi_squared_upper_tail(x, 2);
        if (x <= 1400)
            worst.see(tail.p, std::exp(-static_cast<long double>(x) / 2));
        else
            worst.see(tail.log10_p,
                      -static_cast<long double>(x) / 2 / std::numbers::ln10_v<long double>);
    }
    return worst.result();
}

/// The range of two is sqrt 2 times the size of a t, or of a normal.
Case range_of_two() {
    Worst worst(area,
                "studentized range of two, q from 0.1 to 50, 2 and infinite degrees of freedom",
                closed, 13);
    for (const double q : {0.1, 1.0, 5.0, 20.0, 50.0}) {
        const long double t = q / std::numbers::sqrt2_v<long double>;
        worst.see(studentized_range_upper_tail(q, 2, 2).p, 2 * t_tail_of_two(t));
        worst.see(studentized_range_upper_tail(q, 2, infinity).p, 2 * normal_tail(t));
    }
    return worst.result();
}

} // namespace

void add_statistics(std::vector<Case>& cases) {
    cases.push_back(nist());
    cases.push_back(normal());
    cases.push_back(normal_beyond_doubles());
    cases.push_back(quantiles());
    cases.push_back(student());
    cases.push_back(fisher());
    cases.push_back(chi_squared());
    cases.push_back(range_of_two());
}

} // namespace hard_cases
