// Integers wide enough for sums of squares of votes, and fractions of them, compared without
// rounding.
#pragma once

#include <cstdint>

namespace analysis {

__extension__ typedef __int128 Wide;

/// A rational number whose denominator is positive.
struct Fraction {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;
};

constexpr double to_double(Fraction fraction) {
    return static_cast<double>(fraction.numerator) / static_cast<double>(fraction.denominator);
}

/// Exact, by cross-multiplication.
constexpr bool operator<(Fraction a, Fraction b) {
    return static_cast<Wide>(a.numerator) * b.denominator <
           static_cast<Wide>(b.numerator) * a.denominator;
}

constexpr bool operator==(Fraction a, Fraction b) {
    return static_cast<Wide>(a.numerator) * b.denominator ==
           static_cast<Wide>(b.numerator) * a.denominator;
}

} // namespace analysis
