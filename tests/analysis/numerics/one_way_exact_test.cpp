#include "analysis/numerics/nist_file.h"
#include "analysis/numerics/one_way_exact.h"
#include "tests/analysis/numerics/golden_json.h"
#include "tests/analysis/numerics/golden_table.h"

#include <fmt/format.h>

#include <iterator>
#include <limits>

namespace {

using namespace analysis::numerics;
using golden::Table;
using golden::Worst;

std::string contents(const std::string& path) {
    std::ifstream stream(PAIRLIGHT_TEST_DATA "/" + path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// NIST's data as a program sees them that reads doubles.
std::vector<std::vector<double>> as_doubles(const std::string& text) {
    std::istringstream stream(text.substr(text.rfind("Data:")));
    std::string line;
    std::getline(stream, line);
    std::vector<std::vector<double>> groups;
    std::string label, value, last;
    while (stream >> label >> value) {
        if (label != last)
            groups.emplace_back();
        last = label;
        groups.back().push_back(std::strtod(value.c_str(), nullptr));
    }
    return groups;
}

// Fifteen digits: the golden values are exact rationals, so this is one or two last bits.
constexpr long double fifteen_digits = 1e-15L;

TEST(OneWayExact, HasFifteenDigitsOnAllElevenNistSets) {
    const Table table("nist_exact.csv");
    ASSERT_EQ(table.rows(), 22u);
    Worst worst("NIST");
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const auto name = table.text(i, "set"), input = table.text(i, "input");
        const auto text = contents("nist/" + name + ".dat");
        const auto set = read_nist_one_way(text, name);
        ASSERT_TRUE(set) << set.error();
        const auto sums =
            input == "decimal" ? one_way_exact(set->groups) : one_way_exact(as_doubles(text));
        const auto expect = [&](const char* column, double value) {
            EXPECT_LE(worst.see(input + " " + column, value, table.number(i, column)),
                      fifteen_digits)
                << name << ' ' << column;
        };
        EXPECT_EQ(sums.values, table.argument(i, "N"));
        EXPECT_EQ(sums.df_between, table.argument(i, "df_between"));
        EXPECT_EQ(sums.df_within, table.argument(i, "df_within"));
        expect("SS_between", sums.ss_between);
        expect("MS_between", sums.ms_between);
        expect("SS_within", sums.ss_within);
        expect("MS_within", sums.ms_within);
        expect("F", sums.f);
        expect("R2", sums.r_squared);
        expect("residual_sd", sums.residual_sd);
        if (const long double p = table.number(i, "p"); p > 1e-300L) {
            EXPECT_LE(golden::relative_error(sums.p.p, p), 1e-13L)
                << name; // F's last bit, times df
        } else {
            EXPECT_LE(golden::relative_error(sums.p.log10_p, std::log10(p)), 1e-15L) << name;
        }
    }
}

TEST(OneWayExact, AgreesWithWhatNistCertifies) {
    int sets = 0;
    for (const char* name : {"SiRstv", "SmLs01", "SmLs02", "SmLs03", "AtmWtAg", "SmLs04", "SmLs05",
                             "SmLs06", "SmLs07", "SmLs08", "SmLs09"}) {
        const auto set = read_nist_one_way(contents(fmt::format("nist/{}.dat", name)), name);
        ASSERT_TRUE(set) << set.error();
        const auto sums = one_way_exact(set->groups);
        const auto& certified = set->certified;
        // NIST prints 15 significant digits: half a unit of the last is at most 5e-15.
        EXPECT_LE(golden::relative_error(sums.f, certified.f), 5e-15L) << name;
        EXPECT_LE(golden::relative_error(sums.ss_between, certified.ss_between), 5e-15L) << name;
        EXPECT_LE(golden::relative_error(sums.ss_within, certified.ss_within), 5e-15L) << name;
        EXPECT_LE(golden::relative_error(sums.r_squared, certified.r_squared), 5e-15L) << name;
        EXPECT_LE(golden::relative_error(sums.residual_sd, certified.residual_sd), 5e-15L) << name;
        EXPECT_EQ(sums.df_between, certified.df_between);
        EXPECT_EQ(sums.df_within, certified.df_within);
        ++sets;
    }
    EXPECT_EQ(sets, 11);
}

std::vector<std::vector<Decimal>> decimals(const nlohmann::json& groups) {
    std::vector<std::vector<Decimal>> result;
    for (const auto& group : groups) {
        auto& out = result.emplace_back();
        for (const auto& value : group)
            out.push_back(parse_decimal(value.get<std::string>()).value());
    }
    return result;
}

TEST(OneWayExact, AnswersTheHardCases) {
    const auto cases = golden::read_json("hard_cases.json").at("oneway");
    int seen = 0;
    for (const auto& [name, expected] : cases.items()) {
        const auto sums = one_way_exact(decimals(expected.at("groups")));
        ++seen;
        if (name == "all_equal") {
            EXPECT_TRUE(std::isnan(sums.f) && std::isnan(sums.p.p) && std::isnan(sums.r_squared));
            continue;
        }
        if (name == "zero_within") {
            EXPECT_EQ(sums.f, std::numeric_limits<double>::infinity());
            EXPECT_EQ(sums.p.p, 0.0);
            EXPECT_EQ(sums.r_squared, 1.0);
            continue;
        }
        ASSERT_TRUE(expected.at("F").is_number()) << name;
        EXPECT_DOUBLE_EQ(sums.f, expected.at("F").get<double>()) << name;
        EXPECT_NEAR(sums.p.p / expected.at("p").get<double>(), 1, 1e-14) << name;
        EXPECT_NEAR(sums.p.log10_p / expected.at("log10_p").get<double>(), 1, 1e-14) << name;
    }
    EXPECT_EQ(seen, static_cast<int>(cases.size()));
    EXPECT_GE(seen, 7);
}

TEST(OneWayExact, KeepsFWhereSumsOfSquaresLeaveADouble) {
    const auto group = [](const std::string& power) {
        std::vector<std::vector<Decimal>> groups;
        for (const auto& digits : {"123", "234", "567"}) {
            auto& out = groups.emplace_back();
            for (const char digit : std::string(digits))
                out.push_back(parse_decimal(digit + power).value());
        }
        return one_way_exact(groups);
    };
    EXPECT_EQ(group("e-200").ss_between, 0.0);
    EXPECT_EQ(group("e-200").f, 13.0);
    EXPECT_DOUBLE_EQ(group("e-160").ms_between, 1.3e-319); // subnormal: few digits, but not zero
    EXPECT_EQ(group("e160").ss_within, std::numeric_limits<double>::infinity());
    EXPECT_EQ(group("e160").f, 13.0);
    EXPECT_EQ(group("e160").mean[2], 6e160);
}

// Fifty digits between the largest and the smallest: too wide for integers, still two passes.
TEST(OneWayExact, FallsBackToTwoPassesWhenTheDataSpanTooManyDigits) {
    const std::vector<std::vector<double>> groups{{1e25, 2e25, 4e25}, {1e-25, 3e-25, 2e-25}};
    const auto sums = one_way_exact(groups);
    // The second group is zero beside the first: means 7/3 and 0, within 14/3 (units of 1e25).
    const long double within = 14.0L / 3 * 1e50L, between = 3 * 2 * (7.0L / 6) * (7.0L / 6) * 1e50L;
    EXPECT_LE(golden::relative_error(sums.ss_within, within), 1e-15L);
    EXPECT_LE(golden::relative_error(sums.ss_between, between), 1e-15L);
    EXPECT_NEAR(sums.mean[1] / 2e-25, 1, 1e-15);
}

TEST(OneWayExact, DoesNotCareWhichValueComesFirst) {
    const std::vector<std::vector<double>> groups{{0.1, 0.7, 1e6}, {3.25, -2.0, 0.3, 9.0}};
    const std::vector<std::vector<double>> mirrored{{9.0, 0.3, -2.0, 3.25}, {1e6, 0.7, 0.1}};
    EXPECT_EQ(one_way_exact(groups).f, one_way_exact(mirrored).f);
    EXPECT_EQ(one_way_exact(groups).mean[0], one_way_exact(mirrored).mean[1]);
}

} // namespace
