// Linear ramps with their ends.
#include "renderer/thickness/band_fade.h"

#include "renderer/contract.h"

#include <algorithm>

namespace renderer::thickness {

namespace {

constexpr double fade_seconds = 0.150;

} // namespace

BandFade::BandFade(int available, int bands) : weights_(static_cast<std::size_t>(available), 0.0) {
    EXPECTS(bands >= 1 && bands <= available);
    std::fill_n(weights_.begin(), bands, 1.0);
}

void BandFade::advance(int wanted, double seconds) {
    EXPECTS(wanted >= 1 && static_cast<std::size_t>(wanted) <= weights_.size());
    EXPECTS(seconds >= 0);
    const double step = seconds / fade_seconds;
    for (std::size_t l = 0; l < weights_.size(); ++l)
        weights_[l] = l < static_cast<std::size_t>(wanted) ? std::min(1.0, weights_[l] + step)
                                                           : std::max(0.0, weights_[l] - step);
}

int BandFade::bands() const {
    return static_cast<int>(
        std::count_if(weights_.begin(), weights_.end(), [](double weight) { return weight > 0; }));
}

} // namespace renderer::thickness
