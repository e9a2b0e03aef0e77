// Philox, Sobol' and Owen's scrambling by hashes.
#include "renderer/reference/random.h"

#include "renderer/contract.h"

namespace renderer::reference {

namespace {

constexpr double unit = 0x1p-32;

// Keeps the scrambles' counters apart from those of the independent numbers, whose block number
// stays below.
constexpr std::uint32_t scramble_blocks = 0x80000000u;

// The same for the numbers apart.
constexpr std::uint32_t apart_blocks = 0x40000000u;

constexpr std::uint32_t reversed(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
    x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
    return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

// Flips every bit by a hash of the bits above it: Owen's scramble.  [Burley2020, section 4]
// Takes the bits the other way round.
constexpr std::uint32_t owen_of_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reversed(x);
}

using Directions = std::array<std::array<std::uint32_t, 16>, 4>;

/// Direction numbers, of 16 bits' worth of points.
constexpr Directions sobol_directions() {
    struct Polynomial {
        unsigned degree, coefficients;
        std::array<std::uint32_t, 3> first;
    };

    constexpr std::array<Polynomial, 3> polynomials{
        {{1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}}};
    Directions v{};
    for (unsigned i = 0; i < 16; ++i)
        v[0][i] = 1u << (31 - i);
    for (unsigned d = 1; d < 4; ++d) {
        const auto& [degree, coefficients, first] = polynomials[d - 1];
        for (unsigned i = 0; i < 16; ++i) {
            if (i < degree) {
                v[d][i] = first[i] << (31 - i);
                continue;
            }
            v[d][i] = v[d][i - degree] ^ (v[d][i - degree] >> degree);
            for (unsigned k = 1; k < degree; ++k)
                if ((coefficients >> (degree - 1 - k)) & 1u)
                    v[d][i] ^= v[d][i - k];
        }
    }
    return v;
}

/// The points with one byte of the index set, bits the other way round; the others are their sums.
struct ByteTable {
    std::array<std::array<std::uint32_t, 4>, 256> low{}, high{};
};

constexpr ByteTable sums_of_directions() {
    constexpr Directions v = sobol_directions();
    ByteTable table;
    for (unsigned byte = 0; byte < 256; ++byte)
        for (unsigned d = 0; d < 4; ++d)
            for (unsigned i = 0; i < 8; ++i)
                if ((byte >> i) & 1u) {
                    table.low[byte][d] ^= reversed(v[d][i]);
                    table.high[byte][d] ^= reversed(v[d][i + 8]);
                }
    return table;
}

constexpr ByteTable points = sums_of_directions();

std::array<double, 4> independent(const PathRandom::Name& name, std::uint32_t block) {
    const Words words = philox({name.pixel, name.batch, name.sample, block}, name.seed);
    return {unit * words[0], unit * words[1], unit * words[2], unit * words[3]};
}

} // namespace

Words philox(Words counter, std::uint64_t key) {
    auto k0 = static_cast<std::uint32_t>(key), k1 = static_cast<std::uint32_t>(key >> 32);
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t p0 = 0xD2511F53ull * counter[0], p1 = 0xCD9E8D57ull * counter[2];
        counter = {
            static_cast<std::uint32_t>(p1 >> 32) ^ counter[1] ^ k0, static_cast<std::uint32_t>(p1),
            static_cast<std::uint32_t>(p0 >> 32) ^ counter[3] ^ k1, static_cast<std::uint32_t>(p0)};
        k0 += 0x9E3779B9u;
        k1 += 0xBB67AE85u;
    }
    return counter;
}

std::array<double, 4>
scrambled_sobol(std::uint32_t index, int log2_count, const Words& scrambles, std::uint32_t order) {
    EXPECTS(log2_count >= 0 && log2_count <= 16);
    EXPECTS(index < (1u << log2_count));
    const auto bits = static_cast<unsigned>(log2_count);
    const std::uint32_t shuffled =
        bits == 0 ? 0 : owen_of_reversed(reversed(index << (32 - bits)), order) >> (32 - bits);
    const auto &low = points.low[shuffled & 255u], &high = points.high[shuffled >> 8];
    std::array<double, 4> point{};
    for (unsigned d = 0; d < 4; ++d)
        point[d] = unit * owen_of_reversed(low[d] ^ high[d], scrambles[d]);
    return point;
}

Strata::Strata(std::uint64_t seed, std::uint32_t pixel, std::uint32_t batch) {
    const auto scrambled = [&](std::uint32_t block) {
        return Block{philox({pixel, batch, 0, scramble_blocks + block}, seed),
                     philox({pixel, batch, 1, scramble_blocks + block}, seed)[0]};
    };
    for (std::uint32_t block = 0; block < blocks; ++block)
        blocks_[block] = scrambled(block);
    pixel_ = scrambled(blocks);
}

std::array<double, 2> Strata::in_pixel(std::uint32_t line, int log2_lines) const {
    const auto point = scrambled_sobol(line, log2_lines, pixel_.scrambles, pixel_.order);
    return {point[0], point[1]};
}

PathRandom::PathRandom(const Name& name, const Strata& strata) : PathRandom(name) {
    strata_ = &strata;
}

PathRandom::PathRandom(const Name& name) : name_(name) {
    EXPECTS(name.log2_batch >= 0 && name.log2_batch <= 16);
    EXPECTS(name.sample < (1u << name.log2_batch));
}

void PathRandom::refill() {
    const std::uint32_t block = drawn_ / 4;
    if (drawn_ < stratified_numbers && name_.log2_batch > 0) {
        const auto [scrambles, order] = strata_ != nullptr
                                            ? (*strata_)[block]
                                            : Strata(name_.seed, name_.pixel, name_.batch)[block];
        numbers_ = scrambled_sobol(name_.sample, name_.log2_batch, scrambles, order);
        return;
    }
    numbers_ = independent(name_, block);
}

void PathRandom::refill_apart() {
    apart_ = independent(name_, apart_blocks + drawn_apart_ / 4);
}

} // namespace renderer::reference
