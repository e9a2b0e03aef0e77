#include "renderer/reference/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace {

using namespace renderer::reference;

// [Salmon2011], the known-answer vectors that come with it.
TEST(Philox, GivesThePublishedAnswers) {
    EXPECT_EQ(philox({0, 0, 0, 0}, 0), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox({~0u, ~0u, ~0u, ~0u}, ~0ull),
              (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0a4093822ull),
              (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(ScrambledSobol, HasOnePointInEveryCellOfEveryDimension) {
    for (const int log2_count : {0, 1, 4, 6, 9}) {
        const std::uint32_t count = 1u << log2_count;
        std::array<std::set<unsigned>, 4> cells;
        for (std::uint32_t i = 0; i < count; ++i) {
            const auto point = scrambled_sobol(i, log2_count, {1, 22, 333, 4444}, 5);
            for (std::size_t d = 0; d < 4; ++d)
                cells[d].insert(static_cast<unsigned>(point[d] * count));
        }
        for (const auto& occupied : cells)
            EXPECT_EQ(occupied.size(), count);
    }
}

TEST(ScrambledSobol, FillsEveryElementaryRectangleOfItsFirstTwoDimensions) {
    for (unsigned width = 0; width <= 6; ++width) {
        std::set<unsigned> cells;
        for (std::uint32_t i = 0; i < 64; ++i) {
            const auto point = scrambled_sobol(i, 6, {7, 8, 9, 10}, 11);
            cells.insert(static_cast<unsigned>(point[0] * (1u << width)) * 64 +
                         static_cast<unsigned>(point[1] * (1u << (6 - width))));
        }
        EXPECT_EQ(cells.size(), 64u) << width;
    }
}

std::vector<double> numbers(const PathRandom::Name& name, int count) {
    PathRandom random(name);
    std::vector<double> drawn;
    for (int i = 0; i < count; ++i)
        drawn.push_back(random.next());
    return drawn;
}

TEST(PathRandom, DependsOnItsNameAlone) {
    const PathRandom::Name name{1, 2, 3, 4, 5};
    EXPECT_EQ(numbers(name, 100), numbers(name, 100));
    for (const PathRandom::Name& other :
         {PathRandom::Name{9, 2, 3, 4, 5}, PathRandom::Name{1, 9, 3, 4, 5},
          PathRandom::Name{1, 2, 9, 4, 5}, PathRandom::Name{1, 2, 3, 9, 5}}) {
        const auto a = numbers(name, 100), b = numbers(other, 100);
        for (std::size_t i = 0; i < a.size(); ++i)
            EXPECT_NE(a[i], b[i]) << i;
    }
}

// Only some paths draw numbers apart: what the others are must not depend on it.
TEST(PathRandom, NumbersApartLeaveTheSequenceAlone) {
    const PathRandom::Name name{1, 2, 3, 4, 5};
    const auto alone = numbers(name, 40);
    PathRandom random(name);
    constexpr int count = 100'000;
    double sum = 0, squares = 0;
    for (int i = 0; i < count; ++i) {
        const double apart = random.next_apart();
        ASSERT_TRUE(apart >= 0 && apart < 1);
        sum += apart;
        squares += apart * apart;
        if (i < 40) {
            EXPECT_EQ(random.next(), alone[static_cast<std::size_t>(i)]);
            EXPECT_NE(apart, alone[static_cast<std::size_t>(i)]);
        }
    }
    // 4 standard errors of the mean and of the mean square of uniform numbers
    EXPECT_NEAR(sum / count, 0.5, 4 * std::sqrt(1.0 / 12 / count));
    EXPECT_NEAR(squares / count, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / count));
}

// One in every elementary rectangle of the pixel, and others in the next batch.
TEST(Strata, SpreadLinesOfSightOverThePixel) {
    constexpr int log2_lines = 4;
    const Strata strata(1, 2, 3), next(1, 2, 4);
    for (int wide = 0; wide <= log2_lines; ++wide) {
        std::array<int, 1 << log2_lines> points{};
        for (std::uint32_t line = 0; line < points.size(); ++line) {
            const auto [x, y] = strata.in_pixel(line, log2_lines);
            const auto column = static_cast<std::size_t>(std::ldexp(x, wide));
            const auto row = static_cast<std::size_t>(std::ldexp(y, log2_lines - wide));
            ++points[(row << wide) + column];
            EXPECT_NE(x, next.in_pixel(line, log2_lines)[0]);
        }
        for (const int in_cell : points)
            EXPECT_EQ(in_cell, 1);
    }
}

// 16 moments of 10^5 numbers each, in units of their standard errors: one in 1000 runs would pass 4
// by chance; the seed is fixed.
TEST(PathRandom, IsUniformInEveryPlace) {
    constexpr int paths = 100'000, length = 16;
    std::array<double, length> sum{}, squares{};
    for (int i = 0; i < paths; ++i) {
        const auto drawn = numbers(
            {7, static_cast<std::uint32_t>(i / 16), 0, static_cast<std::uint32_t>(i % 16), 4},
            length);
        for (std::size_t k = 0; k < length; ++k) {
            ASSERT_TRUE(drawn[k] >= 0 && drawn[k] < 1);
            sum[k] += drawn[k];
            squares[k] += drawn[k] * drawn[k];
        }
    }
    for (std::size_t k = 0; k < length; ++k) {
        EXPECT_LE(std::abs(sum[k] / paths - 1.0 / 2), 4 * std::sqrt(1.0 / 12 / paths)) << k;
        EXPECT_LE(std::abs(squares[k] / paths - 1.0 / 3), 4 * std::sqrt(4.0 / 45 / paths)) << k;
    }
}

} // namespace
