// Coefficients by similarity, and the questions that choose a shorter road.
#include "renderer/reference/medium.h"

#include "renderer/contract.h"

#include <algorithm>
#include <cmath>

namespace renderer::reference {

namespace {

bool all_equal(const Spectrum<3>& values) {
    return values[0] == values[1] && values[1] == values[2];
}

} // namespace

Medium medium_from_reduced(const renderer::Medium& medium, double g) {
    EXPECTS(std::abs(g) <= 0.999);
    const auto& a = medium.sigma_a;
    const auto& s = medium.sigma_s_reduced;
    const double factor = 1 / (1 - g);
    return {{a.r, a.g, a.b}, {factor * s.r, factor * s.g, factor * s.b}, g, medium.index};
}

Medium grey_medium(double extinction, double albedo, double anisotropy, double index) {
    EXPECTS(extinction >= 0);
    EXPECTS(albedo >= 0 && albedo <= 1);
    const double s = albedo * extinction, a = (1 - albedo) * extinction;
    return {{a, a, a}, {s, s, s}, anisotropy, index};
}

bool is_grey(const Medium& medium) {
    return all_equal(medium.sigma_a) && all_equal(medium.sigma_s);
}

bool is_clear(const Medium& medium) {
    return std::ranges::all_of(medium.sigma_s, [](double sigma_s) { return sigma_s == 0; });
}

} // namespace renderer::reference
