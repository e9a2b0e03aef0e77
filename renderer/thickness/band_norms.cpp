// Norms rounded up to bytes.
#include "renderer/thickness/band_norms.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer::thickness {

namespace {

double norm_of_band(const ThicknessField& field, std::size_t v, int l) {
    const auto first = v * static_cast<std::size_t>(harmonics::coefficient_count(field.bands)) +
                       static_cast<std::size_t>(l * l);
    double squares = 0;
    for (std::size_t i = first; i < first + static_cast<std::size_t>(2 * l + 1); ++i)
        squares += static_cast<double>(field.coefficients[i]) * field.coefficients[i];
    return std::sqrt(squares);
}

} // namespace

BandNorms band_norms(const ThicknessField& field) {
    const auto bands = static_cast<std::size_t>(field.bands);
    const std::size_t vertices =
        field.coefficients.size() /
        static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    BandNorms norms{field.bands, std::vector<double>(bands),
                    std::vector<std::uint8_t>(vertices * bands)};
    for (int l = 0; l < field.bands; ++l) {
        double largest = 0;
        for (std::size_t v = 0; v < vertices; ++v)
            largest = std::max(largest, norm_of_band(field, v, l));
        // A hair more than 1/255, so that the largest rounds to 255 and not to 256.
        const double step = largest * (1 + 1e-12) / 255;
        norms.step[static_cast<std::size_t>(l)] = step;
        for (std::size_t v = 0; v < vertices && step > 0; ++v)
            norms.norm[v * bands + static_cast<std::size_t>(l)] =
                static_cast<std::uint8_t>(std::ceil(norm_of_band(field, v, l) / step));
    }
    return norms;
}

double dropped_factor(int bands, int available) {
    EXPECTS(bands >= 0 && bands <= available);
    const int dropped =
        harmonics::coefficient_count(available) - harmonics::coefficient_count(bands);
    return std::sqrt(dropped / (4 * std::numbers::pi));
}

double dropped_bound(const BandNorms& norms, std::size_t v, int bands) {
    EXPECTS(bands >= 1 && bands <= norms.bands);
    const auto stride = static_cast<std::size_t>(norms.bands);
    EXPECTS((v + 1) * stride <= norms.norm.size());
    double squares = 0;
    for (auto l = static_cast<std::size_t>(bands); l < stride; ++l)
        squares += std::pow(norms.norm[v * stride + l] * norms.step[l], 2);
    return dropped_factor(bands, norms.bands) * std::sqrt(squares);
}

} // namespace renderer::thickness
