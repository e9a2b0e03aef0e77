// A small generator for draws that are made once and kept: rotations, orders of visiting.
// [Steele2014]
#pragma once

#include <cstdint>

namespace renderer {

/// The state moves on by the golden gamma; the result is its avalanche.
constexpr std::uint64_t splitmix64(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// Uniform in [0, 1), 53 bits.
constexpr double uniform(std::uint64_t& state) {
    return static_cast<double>(splitmix64(state) >> 11) * 0x1p-53;
}

} // namespace renderer
