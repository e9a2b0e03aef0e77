#include "protocols/random.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <numeric>
#include <vector>

namespace {

using namespace protocols;
using boost::multiprecision::cpp_int;

Seed number(std::uint8_t low) {
    Seed seed{};
    seed.back() = low;
    return seed;
}

// Outputs of the generator's author: pcg-cpp, test-high/expected/check-pcg64.out, pcg64 rng(42,
// 54).
TEST(Rng, GivesThePublishedNumbersOfPcg64) {
    Rng rng(number(42), number(54));
    for (const std::uint64_t expected :
         {0x86b1da1d72062b68u, 0x1304aa46c9853d39u, 0xa3670e9e0dd50358u, 0xf9090e529a7dae00u,
          0xc85b9fd837996f2cu, 0x606121f8e3919196u})
        EXPECT_EQ(rng(), expected);
}

// The default stream's increment is 2 * stream + 1, so naming that stream changes nothing.
TEST(Rng, HasADefaultStream) {
    const Seed stream{0x2c, 0x28, 0xfa, 0x16, 0xa6, 0x4a, 0xbf, 0x96,
                      0x8a, 0x02, 0xbd, 0xbf, 0x7b, 0xb3, 0xc0, 0xa7};
    Rng plain(number(7)), named(number(7), stream);
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(plain(), named());
}

TEST(Rng, ReadsItsSeedMostSignificantByteFirst) {
    Seed high{};
    high.front() = 1;
    EXPECT_NE(Rng(high)(), Rng(number(1))());
}

// Pearson's chi-square over `cells` equally likely cells.
double chi_square(const std::vector<int>& cells) {
    const double expected =
        std::accumulate(cells.begin(), cells.end(), 0.0) / static_cast<double>(cells.size());
    double sum = 0;
    for (const auto count : cells)
        sum += (count - expected) * (count - expected) / expected;
    return sum;
}

// Upper 0.001 points of chi-square: 22.46 at 6 degrees of freedom.  The seed is fixed, so this
// passes always or never; under another seed it would fail once in a thousand.
TEST(DrawBelow, IsUniform) {
    Rng rng(number(1));
    std::vector<int> cells(7);
    for (int i = 0; i < 70000; ++i)
        ++cells[draw_below(rng, 7)];
    EXPECT_LE(chi_square(cells), 22.46);
}

// With bound 3 * 2^62 a quarter of all numbers must be rejected: taking remainders instead would
// make the lowest third twice as likely (chi-square 7500 here).  13.82: two degrees, 0.001.
TEST(DrawBelow, RejectsWhatWouldFavourSmallNumbers) {
    Rng rng(number(2));
    constexpr std::uint64_t third = std::uint64_t{1} << 62;
    std::vector<int> cells(3);
    for (int i = 0; i < 30000; ++i)
        ++cells[draw_below(rng, 3 * third) / third];
    EXPECT_LE(chi_square(cells), 13.82);
}

TEST(DrawBelow, OfOneIsZero) {
    Rng rng(number(3));
    EXPECT_EQ(draw_below(rng, 1), 0u);
    EXPECT_EQ(draw_wide_below(rng, cpp_int(1)), 0);
}

TEST(DrawBelowDeathTest, OfNothingIsACallersBug) {
    Rng rng(number(3));
    EXPECT_DEATH(draw_below(rng, 0), "bound > 0");
    EXPECT_DEATH(draw_wide_below(rng, cpp_int(0)), "bound > 0");
}

TEST(DrawWideBelow, IsUniformBeyondSixtyFourBits) {
    Rng rng(number(4));
    const cpp_int part = (cpp_int(1) << 200) + 12345; // a bound just above a power of two
    std::vector<int> cells(5);
    for (int i = 0; i < 50000; ++i) {
        const cpp_int drawn = draw_wide_below(rng, cpp_int(5 * part));
        ASSERT_LT(drawn, 5 * part);
        ++cells[static_cast<std::size_t>(cpp_int(drawn / part))];
    }
    EXPECT_LE(chi_square(cells), 18.47); // four degrees, 0.001
}

// 2^64 - 1 has 64 bits: one draw serves, as it is; 2^65 - 1 has 65: the last comes from a second.
TEST(DrawWideBelow, TakesAsManyBitsAsTheBoundHas) {
    Rng one(number(5)), two(number(5));
    EXPECT_EQ(draw_wide_below(one, cpp_int((cpp_int(1) << 64) - 1)), cpp_int(two()));
    EXPECT_EQ(one(), two());
    draw_wide_below(one, cpp_int((cpp_int(1) << 65) - 1));
    two(), two();
    EXPECT_EQ(one(), two());
}

// Mean 1/2 and variance 1/12; four standard errors of 100,000 draws are 0.0037 and 0.0010.
TEST(DrawUnit, HasTheMomentsOfTheUniformLaw) {
    Rng rng(number(6));
    double sum = 0, squares = 0;
    constexpr int draws = 100000;
    for (int i = 0; i < draws; ++i) {
        const auto u = draw_unit(rng);
        ASSERT_TRUE(u >= 0 && u < 1);
        sum += u;
        squares += (u - 0.5) * (u - 0.5);
    }
    EXPECT_NEAR(sum / draws, 0.5, 0.0037);
    EXPECT_NEAR(squares / draws, 1.0 / 12, 0.0010);
}

TEST(DrawCoin, FallsBothWaysEquallyOften) {
    Rng rng(number(8));
    int heads = 0;
    for (int i = 0; i < 10000; ++i)
        heads += draw_coin(rng) ? 1 : 0;
    EXPECT_NEAR(heads, 5000, 165); // 3.3 standard errors of 50: 0.001
}

TEST(Shuffle, MakesEveryOrderEquallyOften) {
    Rng rng(number(9));
    std::vector<int> cells(24);
    for (int i = 0; i < 48000; ++i) {
        std::vector<int> items{0, 1, 2, 3};
        shuffle(std::span(items), rng);
        // Lehmer code: the rank of the order among the 24.
        const int rank = items[0] * 6 + (items[1] - (items[1] > items[0] ? 1 : 0)) * 2 +
                         (items[2] > items[3] ? 1 : 0);
        ++cells[static_cast<std::size_t>(rank)];
    }
    EXPECT_LE(chi_square(cells), 49.73); // 23 degrees, 0.001
}

TEST(Shuffle, LeavesNothingAndOneAlone) {
    Rng rng(number(10));
    std::vector<int> none, one{5};
    shuffle(std::span(none), rng);
    shuffle(std::span(one), rng);
    EXPECT_EQ(one.front(), 5);
}

} // namespace
