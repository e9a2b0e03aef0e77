// Truncation errors from the stored energy.
#include "renderer/thickness/bands.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace renderer::thickness {

namespace {

double energy_in_bands(const ThicknessField& field, std::size_t v, int bands) {
    EXPECTS(bands >= 1 && bands <= field.bands);
    EXPECTS(v < field.energy.size());
    const auto stride = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    const auto used = static_cast<std::size_t>(harmonics::coefficient_count(bands));
    double sum = 0;
    for (std::size_t i = v * stride; i < v * stride + used; ++i)
        sum += static_cast<double>(field.coefficients[i]) * field.coefficients[i];
    return sum;
}

} // namespace

double truncation_rms(const ThicknessField& field, std::size_t v, int bands) {
    const double lost = field.energy[v] - energy_in_bands(field, v, bands);
    return std::sqrt(std::max(0.0, lost) / (4 * std::numbers::pi)); // below 0 by quadrature only
}

double energy_kept(const ThicknessField& field, int bands) {
    const double total = std::accumulate(field.energy.begin(), field.energy.end(), 0.0);
    double kept = 0;
    for (std::size_t v = 0; v < field.energy.size(); ++v)
        kept += energy_in_bands(field, v, bands);
    return total > 0 ? std::min(1.0, kept / total) : 1;
}

} // namespace renderer::thickness
