// PCG64, after its author's reference implementation (pcg-cpp, setseq_xsl_rr_128_64).
#include "protocols/random.h"

#include <bit>

namespace protocols {

namespace {

constexpr Uint128 wide(std::uint64_t high, std::uint64_t low) {
    return (static_cast<Uint128>(high) << 64) | low;
}

constexpr Uint128 multiplier = wide(0x2360ed051fc65da4, 0x4385df649fccf645);
constexpr Uint128 default_increment = wide(0x5851f42d4c957f2d, 0x14057b7ef767814f);

Uint128 to_number(const Seed& seed) {
    Uint128 number = 0;
    for (const auto byte : seed)
        number = (number << 8) | byte;
    return number;
}

} // namespace

Rng::Rng(const Seed& seed) : Rng(seed, default_increment) {}

Rng::Rng(const Seed& seed, const Seed& stream) : Rng(seed, (to_number(stream) << 1) | 1) {}

Rng::Rng(const Seed& seed, Uint128 increment)
    : increment_(increment), state_((to_number(seed) + increment) * multiplier + increment) {}

std::uint64_t Rng::operator()() {
    state_ = state_ * multiplier + increment_;
    const auto high = static_cast<std::uint64_t>(state_ >> 64);
    const auto low = static_cast<std::uint64_t>(state_);
    return std::rotr(high ^ low, static_cast<int>(high >> 58));
}

std::uint64_t draw_below(Rng& rng, std::uint64_t bound) {
    EXPECTS(bound > 0);
    // 2^64 mod bound: below it, remainders would come up once too often.
    const auto surplus = (0 - bound) % bound;
    while (true)
        if (const auto drawn = rng(); drawn >= surplus)
            return drawn % bound;
}

double draw_unit(Rng& rng) {
    return static_cast<double>(rng() >> 11) * 0x1p-53;
}

bool draw_coin(Rng& rng) {
    return (rng() >> 63) != 0;
}

} // namespace protocols
