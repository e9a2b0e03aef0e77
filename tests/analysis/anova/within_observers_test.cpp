#include "analysis/anova/within_observers.h"
#include "tests/analysis/numerics/golden_json.h"

#include <cmath>

namespace {

using namespace analysis::anova;
using nlohmann::json;

constexpr double digits = 1e-13; // integer input: a few roundings at the end

void expect_near(const json& expected, double found, const char* what) {
    if (expected.is_null())
        EXPECT_TRUE(std::isnan(found)) << what;
    else
        EXPECT_LE(std::abs(found - expected.get<double>()),
                  digits * std::abs(expected.get<double>()))
            << what << " " << found;
}

std::vector<std::int64_t> doubled(const json& rows) {
    std::vector<std::int64_t> values;
    for (const auto& row : rows)
        for (const auto& value : row)
            values.push_back(std::llround(2 * std::stod(value.get<std::string>())));
    return values;
}

WithinEffect hard_case(const std::string& name, json& expected) {
    expected = golden::read_json("hard_cases.json")["repeated_measures"][name];
    const auto rows = expected["rows"];
    const auto table =
        within_observers_of_counts(rows.size(), {{"method", rows[0].size()}}, doubled(rows), 2);
    return table.effects.at(0);
}

TEST(WithinObservers, AgreeWithTheHardCases) {
    for (const auto* name : {"three_observers_four_methods", "sum_fixed"}) {
        json expected;
        const auto effect = hard_case(name, expected);
        expect_near(expected["SS"], effect.effect.ss, "SS");
        expect_near(expected["SS_error"], effect.error.ss, "SS_error");
        expect_near(expected["F"], effect.test.f, "F");
        expect_near(expected["p"], effect.test.p, "p");
        expect_near(expected["mauchly_W"], effect.sphericity.mauchly_w, "W");
        expect_near(expected["GG"], effect.sphericity.greenhouse_geisser, "GG");
        expect_near(expected["HF_raw"], effect.sphericity.huynh_feldt_raw, "HF");
        expect_near(expected["p_GG"], effect.sphericity.p_greenhouse_geisser, "p_GG");
        expect_near(expected["p_lower_bound"], effect.sphericity.p_lower_bound, "p_lower");
    }
}

TEST(WithinObservers, IdenticalObserversMakeFInfinite) {
    json expected;
    const auto effect = hard_case("identical_observers", expected);
    EXPECT_EQ(effect.test.outcome, Outcome::Infinite);
    EXPECT_EQ(effect.error.ss, 0);
    EXPECT_TRUE(std::isnan(effect.sphericity.greenhouse_geisser));
}

TEST(WithinObservers, TwoLevelsHaveNoSphericityQuestion) {
    const std::vector<std::int64_t> values{3, 1, 2, 2, 4, 1};
    const auto effect = within_observers_of_counts(3, {{"method", 2}}, values, 1).effects[0];
    EXPECT_TRUE(std::isnan(effect.sphericity.greenhouse_geisser));
    EXPECT_THAT(effect.sphericity.reason, testing::HasSubstr("two levels"));
    // F of two levels is the square of the paired t: differences 2, 0, 3
    EXPECT_NEAR(effect.test.f, std::pow(5.0 / 3 / std::sqrt(7.0 / 3 / 3), 2), 1e-13);
}

// Reals go through other arithmetic than counts.
TEST(WithinObservers, CountsAndRealsAgree) {
    std::vector<std::int64_t> counts;
    std::vector<double> reals;
    for (std::int64_t i = 0; i < 5 * 3 * 2 * 4; ++i) {
        counts.push_back((i * i * 31 + 17 * i) % 23);
        reals.push_back(1e6 + static_cast<double>(counts.back()) / 4);
    }
    const std::vector<Factor> factors{{"session", 3}, {"light", 2}, {"method", 4}};
    const auto exact = within_observers_of_counts(5, factors, counts, 4);
    const auto real = within_observers(5, factors, reals);
    ASSERT_EQ(exact.effects.size(), 7u);
    for (std::size_t e = 0; e < 7; ++e) {
        EXPECT_EQ(exact.effects[e].name, real.effects[e].name);
        EXPECT_NEAR(exact.effects[e].test.f / real.effects[e].test.f, 1, 1e-12);
    }
    EXPECT_EQ(exact.effects[3].name, "session:light");
    EXPECT_NEAR(exact.total.ss / real.total.ss, 1, 1e-12);
    EXPECT_EQ(exact.total.df, 119);
}

TEST(WithinObservers, RealScoresThatSumToAConstantHaveNoObserverEffect) {
    // shares of a third: not representable, so only rounding is left between observers
    const std::vector<double> values{2.0 / 3, 1.0 / 3, 0.5, 1.0 / 6, 5.0 / 6, 0.5};
    const auto table = within_observers(2, {{"method", 3}}, values);
    EXPECT_EQ(table.subject.ss, 0);
    EXPECT_GT(table.effects[0].error.ss, 0.1);
}

} // namespace
