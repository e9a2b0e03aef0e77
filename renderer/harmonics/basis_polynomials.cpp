// Constants by the three-term recurrence over every second degree, in extended precision.
//
// With z P_l = e_{l+1} P_{l+1} + e_l P_{l-1}, e_l^2 = (l^2 - m^2) / (4 l^2 - 1), taken twice:
//   (2z^2 - 1) P_l = d_l P_{l+2} + (2 e_{l+1}^2 + 2 e_l^2 - 1) P_l + d_{l-2} P_{l-2},
//   d_l = 2 e_{l+1} e_{l+2}.
#include "renderer/harmonics/basis_polynomials.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis_kernels.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace renderer::harmonics {

namespace {

using Polynomial = std::vector<long double>; // lowest power first

long double squared_step(int l, int m) {
    return l <= m ? 0 : static_cast<long double>(l * l - m * m) / (4 * l * l - 1);
}

long double double_step(int l, int m) {
    return 2 * std::sqrt(squared_step(l + 1, m) * squared_step(l + 2, m));
}

/// P_{l+2} from P_l and P_{l-2}.
Polynomial next_degree(int l, int m, const Polynomial& p, const Polynomial& before) {
    Polynomial next(p.size() + 1);
    const long double constant = 2 * squared_step(l + 1, m) + 2 * squared_step(l, m) - 1;
    for (std::size_t i = 0; i < p.size(); ++i) {
        next[i + 1] += p[i];
        next[i] -= constant * p[i];
    }
    for (std::size_t i = 0; i < before.size(); ++i)
        next[i] -= double_step(l - 2, m) * before[i];
    for (auto& each : next)
        each /= double_step(l, m);
    return next;
}

template <class T>
void append_order(int bands, int m, int parity, long double first, std::vector<T>& constants) {
    Polynomial before, p{first};
    for (int l = m + parity; l < bands; l += 2) {
        for (std::size_t i = p.size(); i-- > 0;)
            constants.push_back(static_cast<T>(p[i]));
        auto next = next_degree(l, m, p, before);
        before = std::exchange(p, std::move(next));
    }
}

template <class T>
std::vector<T> constants_of(int bands) {
    using std::numbers::inv_sqrtpi_v, std::numbers::sqrt2_v;
    std::vector<T> constants;
    long double sectoral = inv_sqrtpi_v<long double> / 2; // P_mm
    for (int m = 0; m < bands; ++m) {
        if (m > 0)
            sectoral *= std::sqrt((2.0L * m + 1) / (2.0L * m));
        const long double first = m == 0 ? sectoral : sqrt2_v<long double> * sectoral;
        append_order(bands, m, 0, first, constants);
        append_order(bands, m, 1, first * std::sqrt(2.0L * m + 3), constants);
    }
    return constants;
}

template <class T>
std::array<std::vector<T>, most_unrolled_bands> all_constants() {
    std::array<std::vector<T>, most_unrolled_bands> all;
    for (int bands = 1; bands <= most_unrolled_bands; ++bands)
        all[static_cast<std::size_t>(bands - 1)] = constants_of<T>(bands);
    return all;
}

} // namespace

template <class T>
std::span<const T> polynomial_constants(int bands) {
    EXPECTS(bands >= 1 && bands <= most_unrolled_bands);
    static const auto all = all_constants<T>();
    return all[static_cast<std::size_t>(bands - 1)];
}

template std::span<const float> polynomial_constants<float>(int bands);
template std::span<const double> polynomial_constants<double>(int bands);

} // namespace renderer::harmonics
