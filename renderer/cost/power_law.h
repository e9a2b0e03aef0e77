// How something grows: y = a x^b, by a straight line through logarithms.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace renderer::cost {

struct PowerLaw {
    double exponent = 0;       ///< b
    double standard_error = 0; ///< of b, from what the line leaves over
    double factor = 0;         ///< a
    double worst_ratio = 1;    ///< of a point to the line, or the line to it, at most
    std::size_t points = 0;
};

/// Least squares of log y on log x.  Nothing with fewer than three points, with equal x, or with a
/// number that is not above 0 and finite.
/// Errors: EXPECTS as many y as x.
std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y);

} // namespace renderer::cost
