// A histogram over the leading bits of floats.
#include "renderer/thickness/percentile.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>

namespace renderer::thickness {

namespace {

// A float's bits grow with its value; dropping 15 of the significand's 23 leaves 256 per octave.
constexpr int dropped_bits = 15;

constexpr std::uint32_t bin_of(float length) {
    return std::bit_cast<std::uint32_t>(length) >> dropped_bits;
}

constexpr std::uint32_t first_bin = bin_of(0x1p-32f), end_bin = bin_of(2.0f);

double lower_edge(std::size_t index) {
    const auto bin = first_bin + static_cast<std::uint32_t>(index);
    return std::bit_cast<float>(bin << dropped_bits);
}

} // namespace

LengthHistogram::LengthHistogram() : weights_(end_bin - first_bin) {}

void LengthHistogram::add(float length, std::uint64_t weight) {
    if (length > 0x1p-32f)
        weights_[std::min(bin_of(length), end_bin - 1) - first_bin] += weight;
}

LengthHistogram& LengthHistogram::operator+=(const LengthHistogram& other) {
    std::transform(weights_.begin(), weights_.end(), other.weights_.begin(), weights_.begin(),
                   std::plus<>());
    return *this;
}

double LengthHistogram::percentile(double fraction) const {
    const auto total = std::accumulate(weights_.begin(), weights_.end(), std::uint64_t{0});
    if (total == 0)
        return 0;
    const double wanted = fraction * static_cast<double>(total);
    double below = 0;
    for (std::size_t i = 0;; ++i) {
        const auto here = static_cast<double>(weights_[i]);
        if (here > 0 && (below + here >= wanted || i + 1 == weights_.size())) {
            const double share = std::min(1.0, (wanted - below) / here);
            return lower_edge(i) + share * (lower_edge(i + 1) - lower_edge(i));
        }
        below += here;
    }
}

} // namespace renderer::thickness
