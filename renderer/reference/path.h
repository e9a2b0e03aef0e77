// What a path of light carries: all channels are followed at once.
//
// Distances are drawn for one of them, the hero, chosen once per path; `ratio` keeps how probable
// the same path would have been under each other hero, and the weight of a channel is divided by
// the mean of the three: the balance heuristic over whole paths. [Wilkie2014] [Miller2019]  Weights
// then never exceed three times those of a walk in one colour.
#pragma once

#include "renderer/reference/medium.h"

#include <glm/vec3.hpp>

#include <cstddef>

namespace renderer::reference {

template <std::size_t N>
constexpr Spectrum<N> all_ones() {
    Spectrum<N> ones;
    ones.fill(1);
    return ones;
}

/// The last turn at which a connection to the light was possible.  Few paths end in a light, so
/// that the medium's density is left to be worked out by who needs it.
struct Turn {
    enum class By { Nothing, Medium, Surface }; ///< Nothing: no light could be asked for
    By by = By::Nothing;
    double cosine = 1;  ///< By::Medium: of the angle turned by
    double density = 0; ///< By::Surface: per steradian
};

/// Where a path is and what it carries.  N channels: three, or one when one says all.
template <std::size_t N>
struct Path {
    glm::dvec3 position{};
    glm::dvec3 direction{0, 0, 1};
    bool is_inside = false;
    std::size_t hero = 0;
    Spectrum<N> weight = all_ones<N>(); ///< contribution per unit of light, ratios divided out
    Spectrum<N> ratio = all_ones<N>();  ///< density under each hero over the mean of all
    int collisions = 0;
    Turn turn;
};

/// Divides the ratios' mean out of weights and ratios; returns what both were multiplied by.
template <std::size_t N>
double balance(Path<N>& path) {
    double sum = 0;
    for (const double ratio : path.ratio)
        sum += ratio;
    const double factor = static_cast<double>(N) / sum;
    for (std::size_t k = 0; k < N; ++k) {
        path.weight[k] *= factor;
        path.ratio[k] *= factor;
    }
    return factor;
}

/// Multiplies the weight of each channel by f_k / p_h, its ratio by p_k / p_h.  Returns the weight
/// it would have for `other` instead of `f`.  p of the hero is above 0: it drew what happened.
template <std::size_t N>
Spectrum<N>
advance(Path<N>& path, const Spectrum<N>& f, const Spectrum<N>& p, const Spectrum<N>& other) {
    Spectrum<N> otherwise;
    if constexpr (N == 1) { // one hero: its ratio is 1
        otherwise[0] = path.weight[0] * (other[0] / p[0]);
        path.weight[0] *= f[0] / p[0]; // exactly 1 where nothing absorbs
        return otherwise;
    }
    const double per_density = 1 / p[path.hero];
    for (std::size_t k = 0; k < N; ++k) {
        otherwise[k] = path.weight[k] * other[k] * per_density;
        path.weight[k] *= f[k] * per_density;
        path.ratio[k] *= p[k] * per_density;
    }
    const double factor = balance(path);
    for (auto& weight : otherwise)
        weight *= factor;
    return otherwise;
}

} // namespace renderer::reference
