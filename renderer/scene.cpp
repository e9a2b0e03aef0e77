// Matter's derived coefficients.
#include "renderer/scene.h"

#include <cmath>

namespace renderer {

namespace {

double effective_transport(double sigma_a, double sigma_s_reduced) {
    return std::sqrt(3.0 * sigma_a * (sigma_a + sigma_s_reduced));
}

} // namespace

RgbPerMillimetre effective_transport(const Medium& medium) {
    const auto& a = medium.sigma_a;
    const auto& s = medium.sigma_s_reduced;
    return {effective_transport(a.r, s.r), effective_transport(a.g, s.g),
            effective_transport(a.b, s.b)};
}

} // namespace renderer
