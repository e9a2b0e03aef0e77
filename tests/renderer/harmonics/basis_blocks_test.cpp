// Many directions at once: as exact as stated, the same to the last bit however they are evaluated.
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/basis_blocks.h"
#include "renderer/harmonics/directions.h"
#include "tests/renderer/harmonics/exact_basis.h"

#include <glm/geometric.hpp>

#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

namespace {

using namespace renderer::harmonics;

/// Over the whole sphere, dense about the poles and the equator down to where coordinates vanish,
/// and on the axes.
std::vector<glm::dvec3> telling_directions() {
    auto directions = fibonacci_directions(4000, 3).directions;
    for (int decade = 1; decade <= 20; ++decade)
        for (const auto& s :
             fibonacci_directions(60, static_cast<std::uint64_t>(decade)).directions) {
            const double small = std::pow(10.0, -decade);
            directions.push_back(glm::normalize(glm::dvec3(small * s.x, small * s.y, s.z)));
            directions.push_back(glm::normalize(glm::dvec3(s.x, s.y, small * s.z)));
            directions.push_back(glm::normalize(glm::dvec3(small * s.x, s.y, s.z)));
        }
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            glm::dvec3 s(0);
            s[axis] = sign;
            directions.push_back(s);
        }
    return directions;
}

template <class T>
std::vector<Line<T>> evaluated(int bands,
                               const std::vector<glm::dvec3>& directions,
                               InstructionSet set = instruction_sets().back()) {
    const auto blocks = in_blocks<T>(directions);
    std::vector<Line<T>> values(blocks.size() * static_cast<std::size_t>(bands * bands));
    evaluate_blocks<T>(bands, blocks, values, set);
    return values;
}

template <class T>
T value_of(const std::vector<Line<T>>& values, int bands, std::size_t j, std::size_t i) {
    const auto n = static_cast<std::size_t>(bands * bands), width = std::size_t{lanes<T>};
    return values[j / width * n + i].at[j % width];
}

/// The largest difference from the exact value in the direction that x, y and z of type T point to.
template <class T>
double worst_error(int bands) {
    const auto directions = telling_directions();
    const auto values = evaluated<T>(bands, directions);
    double worst = 0;
    for (std::size_t j = 0; j < directions.size(); ++j) {
        const auto& s = directions[j];
        const auto exact =
            exact_basis(bands, {static_cast<T>(s.x), static_cast<T>(s.y), static_cast<T>(s.z)});
        for (std::size_t i = 0; i < exact.size(); ++i) {
            const auto error = static_cast<double>(
                std::abs(static_cast<long double>(value_of(values, bands, j, i)) - exact[i]));
            worst = error <= worst ? worst : error; // NaN is the worst
        }
    }
    return worst;
}

TEST(BasisBlocks, AreExactTo2e15InFiveBandsAnd12e15InTen) {
    for (int bands = 1; bands <= 5; ++bands)
        EXPECT_LE(worst_error<double>(bands), 2e-15) << bands;
    for (int bands = 6; bands <= most_unrolled_bands; ++bands)
        EXPECT_LE(worst_error<double>(bands), 1.2e-14) << bands;
}

TEST(BasisBlocks, InFloatAreExactTo7e7InFiveBandsAnd18e7InTen) {
    for (int bands = 1; bands <= 5; ++bands)
        EXPECT_LE(worst_error<float>(bands), 7e-7) << bands;
    for (int bands = 6; bands <= most_unrolled_bands; ++bands)
        EXPECT_LE(worst_error<float>(bands), 1.8e-6) << bands;
}

template <class T>
void expect_equal_bits(const std::vector<Line<T>>& a, const std::vector<Line<T>>& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Line<T>)), 0);
}

// Nothing is fused, so nothing differs.
TEST(BasisBlocks, AreTheSameBitsWithEveryInstructionSet) {
    const auto directions = telling_directions();
    ASSERT_EQ(instruction_sets().front(), InstructionSet::Baseline);
    for (const auto set : instruction_sets())
        for (int bands = 1; bands <= most_unrolled_bands; ++bands) {
            SCOPED_TRACE(std::string(name_of(set)) + ", bands: " + std::to_string(bands));
            expect_equal_bits(evaluated<double>(bands, directions, set),
                              evaluated<double>(bands, directions, InstructionSet::Baseline));
            expect_equal_bits(evaluated<float>(bands, directions, set),
                              evaluated<float>(bands, directions, InstructionSet::Baseline));
        }
}

TEST(BasisBlocks, GiveEveryDirectionWhatItHasAlone) {
    const auto directions = telling_directions();
    for (int bands = 1; bands <= most_unrolled_bands; ++bands) {
        std::vector<double> alone(static_cast<std::size_t>(bands * bands));
        std::size_t seen = 0;
        for_each_basis(bands, directions, [&](std::size_t j, const LaneValues& y) {
            EXPECT_EQ(j, seen++);
            evaluate(bands, directions[j], alone);
            for (std::size_t i = 0; i < alone.size(); ++i)
                ASSERT_EQ(std::bit_cast<std::uint64_t>(y[i]),
                          std::bit_cast<std::uint64_t>(alone[i]))
                    << "bands " << bands << ", direction " << j << ", value " << i;
        });
        EXPECT_EQ(seen, directions.size());
    }
}

TEST(BasisBlocks, DoNotCareWhereInItsBlockADirectionStands) {
    auto directions = telling_directions();
    const int bands = 7;
    const auto before = evaluated<float>(bands, directions);
    directions.insert(directions.begin(), 5, {0.6, 0, 0.8});
    const auto after = evaluated<float>(bands, directions);
    for (std::size_t j = 5; j < directions.size(); ++j)
        for (std::size_t i = 0; i < 49; ++i)
            ASSERT_EQ(std::bit_cast<std::uint32_t>(value_of(after, bands, j, i)),
                      std::bit_cast<std::uint32_t>(value_of(before, bands, j - 5, i)))
                << j << ' ' << i;
}

template <class T>
void expect_zero_orders_at_poles() {
    const std::vector<glm::dvec3> poles{{0, 0, 1}, {0, 0, -1}, {-0.0, 0, 1}, {0, -0.0, -1}};
    for (const auto set : instruction_sets()) {
        const int bands = most_unrolled_bands;
        const auto values = evaluated<T>(bands, poles, set);
        for (std::size_t j = 0; j < poles.size(); ++j)
            for (int l = 0; l < bands; ++l)
                for (int m = -l; m <= l; ++m)
                    if (m != 0) {
                        EXPECT_EQ(
                            value_of(values, bands, j, static_cast<std::size_t>(flat_index(l, m))),
                            0)
                            << name_of(set) << ' ' << l << ' ' << m;
                    }
    }
}

TEST(BasisBlocks, OrdersVanishExactlyAtThePoles) {
    expect_zero_orders_at_poles<double>();
    expect_zero_orders_at_poles<float>();
}

TEST(BasisBlocks, OfNoDirectionsAreNone) {
    EXPECT_TRUE(in_blocks<double>({}).empty());
    evaluate_blocks<double>(5, {}, {});
    for_each_basis(5, {}, [](std::size_t, const LaneValues&) { FAIL(); });
}

TEST(BasisBlocksDeathTest, RefuseWhatTheyCannotDo) {
    const std::vector<glm::dvec3> long_one{{0, 0, 1.01}}, nan{{0, std::nan(""), 1}}, up{{0, 0, 1}};
    EXPECT_DEATH(in_blocks<double>(long_one), "1e-6");
    EXPECT_DEATH(in_blocks<float>(nan), "1e-6");
    const auto blocks = in_blocks<double>(up);
    std::vector<Line<double>> values(121);
    EXPECT_DEATH(evaluate_blocks<double>(11, blocks, values), "most_unrolled_bands");
    EXPECT_DEATH(evaluate_blocks<double>(5, blocks, values), "values.size");
}

} // namespace
