// Random numbers by counting: the n-th number of a path is a function of (seed, pixel, batch,
// the batch's size, sample, n) alone, so that a picture is the same for any order of its pixels and
// any number of threads.
//
// Lines of sight are stratified over a pixel, the first numbers of the paths behind them over all
// the paths of a batch, where that pays (first flights and turns); the rest are independent.
// Batches are independent of each other, so that the spread of their means is an honest standard
// error.
#pragma once

#include <array>
#include <cstdint>

namespace renderer::reference {

using Words = std::array<std::uint32_t, 4>;

/// Philox-4x32 with ten rounds: 128 random bits for a 128-bit counter and a 64-bit key.
/// Source: [Salmon2011]; checked against that paper's known answers.
Words philox(Words counter, std::uint64_t key);

/// The first four dimensions of Sobol's sequence, [0, 1), each with its own Owen scramble, and its
/// points in an order of their own: point `index` of the 2^log2_count there are.
/// The points stratify every dimension into 2^log2_count cells, and the first two dimensions
/// jointly into every elementary rectangle of that area.
/// Source: [Joe2008] direction numbers, [Burley2020] scrambling by hashes.
std::array<double, 4>
scrambled_sobol(std::uint32_t index, int log2_count, const Words& scrambles, std::uint32_t order);

/// What the stratified numbers of all paths of a batch have in common.
class Strata {
  public:
    Strata(std::uint64_t seed, std::uint32_t pixel, std::uint32_t batch);

    /// The scrambles of a block of four numbers, and the order of its points.
    struct Block {
        Words scrambles{};
        std::uint32_t order = 0;
    };

    static constexpr std::uint32_t blocks = 5;

    const Block& operator[](std::uint32_t block) const { return blocks_[block]; }

    /// Where in the pixel line `line` of 2^log2_lines runs: both in [0, 1).
    std::array<double, 2> in_pixel(std::uint32_t line, int log2_lines) const;

  private:
    std::array<Block, blocks> blocks_;
    Block pixel_;
};

/// The numbers of one path, in order.
class PathRandom {
  public:
    /// Which path.  Samples are numbered 0..2^log2_batch - 1 within their batch (log2_batch 0..16).
    struct Name {
        std::uint64_t seed = 0;
        std::uint32_t pixel = 0;
        std::uint32_t batch = 0;
        std::uint32_t sample = 0;
        int log2_batch = 0;
    };

    /// So many numbers are stratified over a batch.
    static constexpr std::uint32_t stratified_numbers = 4 * Strata::blocks;

    explicit PathRandom(const Name& name);

    /// The same numbers, quicker: `strata` are those of the name's seed, pixel and batch, and
    /// outlive the path.
    PathRandom(const Name& name, const Strata& strata);

    /// The next number, uniform in [0, 1): at most 1 - 2^-32.
    double next() {
        if (drawn_ % 4 == 0)
            refill();
        return numbers_[drawn_++ % 4];
    }

    /// An independent number apart from the sequence, whose order it leaves alone: for choices that
    /// only some paths have to make.
    double next_apart() {
        if (drawn_apart_ % 4 == 0)
            refill_apart();
        return apart_[drawn_apart_++ % 4];
    }

  private:
    void refill();
    void refill_apart();

    Name name_;
    const Strata* strata_ = nullptr; // without, they are made when they are needed
    std::uint32_t drawn_ = 0;
    std::array<double, 4> numbers_{};
    std::uint32_t drawn_apart_ = 0;
    std::array<double, 4> apart_{};
};

} // namespace renderer::reference
