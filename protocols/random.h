// PCG64 (XSL-RR output of a 128-bit congruential generator) and the few draws made with it.
// Our own, because the standard library's distributions differ from one library to the next.
// Source: M. O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms
// for Random Number Generation", HMC-CS-2014-0905.
#pragma once

#include "protocols/contract.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace protocols {

__extension__ using Uint128 = unsigned __int128; // not ISO C++, but both our compilers have it

/// 128 bits, most significant byte first.
using Seed = std::array<std::uint8_t, 16>;

/// A stream of 64-bit numbers; the same on every machine.
class Rng {
  public:
    static constexpr std::string_view name = "pcg64-xsl-rr";

    explicit Rng(const Seed& seed);

    /// One of 2^127 streams; the constructor above uses PCG's default stream.
    Rng(const Seed& seed, const Seed& stream);

    std::uint64_t operator()();

  private:
    Rng(const Seed& seed, Uint128 increment);

    Uint128 increment_;
    Uint128 state_;
};

/// Uniform over 0..bound-1, exactly, by rejection.  Errors: EXPECTS(bound > 0).
std::uint64_t draw_below(Rng& rng, std::uint64_t bound);

/// Uniform over [0, 1), a multiple of 2^-53.
double draw_unit(Rng& rng);

/// Either of two, each with chance one half.
bool draw_coin(Rng& rng);

/// As `draw_below`, for integers of any width that have `msb` (boost::multiprecision::cpp_int).
/// Draws as many bits as `bound` has and tries again while they make too large a number: fewer than
/// two tries on average.
template <class Wide>
Wide draw_wide_below(Rng& rng, const Wide& bound) {
    EXPECTS(bound > 0);
    const auto bits = static_cast<unsigned>(msb(bound)) + 1;
    while (true) {
        Wide drawn = 0;
        for (unsigned filled = 0; filled < bits; filled += 64) {
            const auto taken = std::min(64u, bits - filled);
            drawn = (drawn << taken) | Wide(rng() >> (64 - taken));
        }
        if (drawn < bound)
            return drawn;
    }
}

/// Every order equally likely: Fisher-Yates, from the end.
template <class T>
void shuffle(std::span<T> items, Rng& rng) {
    for (std::size_t end = items.size(); end > 1; --end)
        std::swap(items[end - 1], items[static_cast<std::size_t>(draw_below(rng, end))]);
}

} // namespace protocols
