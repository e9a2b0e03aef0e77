// Matter as the transport equation sees it: how often light is absorbed and scattered, and whither.
#pragma once

#include "renderer/scene.h"

#include <array>
#include <cstddef>

namespace renderer::reference {

/// One number per colour channel, or one for all of them.
template <std::size_t N>
using Spectrum = std::array<double, N>;

/// Coefficients per unit of length (millimetres in pictures), red, green, blue.
struct Medium {
    Spectrum<3> sigma_a{};
    Spectrum<3> sigma_s{};
    double anisotropy = 0; ///< g, mean cosine of the scattering angle: -0.999..0.999
    double index = 1;      ///< inside over outside, > 0
};

/// The same matter with the scattering it has at anisotropy `g`: sigma_s = sigma_s' / (1 - g).
/// At g = 0, the default, this is what the diffusion-based methods know of it.
/// Errors: EXPECTS |g| <= 0.999.
Medium medium_from_reduced(const renderer::Medium& medium, double g = 0);

/// A medium that treats all channels alike.
/// Errors: EXPECTS extinction >= 0 and an albedo in 0..1.
Medium grey_medium(double extinction, double albedo, double anisotropy, double index);

inline double extinction(const Medium& medium, std::size_t channel) {
    return medium.sigma_a[channel] + medium.sigma_s[channel];
}

/// Whether one channel's walk says all three.
bool is_grey(const Medium& medium);

/// Whether light is only ever absorbed.
bool is_clear(const Medium& medium);

} // namespace renderer::reference
