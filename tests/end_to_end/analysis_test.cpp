// The two commands that analyse tables, from outside: what scripts rely on.
#include "tests/end_to_end/program.h"

#include <nlohmann/json.hpp>

namespace {

using namespace tests;
using nlohmann::json;
using testing::HasSubstr;

const std::string data = PAIRLIGHT_TEST_DATA;

TEST(AnovaCommand, ReadsNistFilesToTheLastDigit) {
    const TemporaryFolder folder;
    const auto out = (folder / "smls09.json").string();
    const auto outcome =
        pairlight({"anova", data + "/nist/SmLs09.dat", "--nist", "--json", out, "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const auto found = json::parse(read_file(out));
    EXPECT_EQ(found["terms"]["Treatment"]["F"], 2001.0);
    EXPECT_EQ(found["terms"]["Treatment"]["SS"], 160.08);
    EXPECT_EQ(found["terms"]["residual"]["SS"], 180.0);
    EXPECT_EQ(found["terms"]["residual"]["sd"], 0.1);
    EXPECT_NEAR(found["r_squared"].get<double>(), 4.70712773465067e-1, 1e-15);
}

TEST(AnovaCommand, HasTypesAndWithinDesigns) {
    const TemporaryFolder folder;
    const auto out = (folder / "out.json").string();
    const auto set = data + "/golden/sets/unbalanced_2way.csv";
    auto outcome = pairlight({"anova", set, "--response", "y", "--factor", "method", "--factor",
                              "model", "--type", "3", "--json", out});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NEAR(json::parse(read_file(out))["terms"]["method"]["SS"].get<double>(),
                24.007196669577404, 1e-13);
    write_file(folder / "within.csv", "who,what,y\n1,a,2.5\n1,b,1.5\n1,c,0.5\n1,d,1.5\n2,a,2\n2,b,"
                                      "1\n2,c,1\n2,d,2\n3,a,3\n3,b,1\n3,c,0\n3,d,2\n");
    outcome = pairlight({"anova", (folder / "within.csv").string(), "--response", "y", "--factor",
                         "what", "--within", "who", "--json", out});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto what = json::parse(read_file(out))["terms"]["what"];
    EXPECT_NEAR(what["F"].get<double>(), 10, 1e-13);
    EXPECT_NEAR(what["GG"].get<double>(), 8.0 / 15, 1e-14);
    EXPECT_EQ(what["df_error"], 6.0);
}

TEST(AnovaCommand, RefusesInOneLine) {
    const auto outcome =
        pairlight({"anova", data + "/golden/sets/unbalanced_2way_empty_cell.csv", "--response", "y",
                   "--factor", "method", "--factor", "model", "--type", "3"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr("no values for "));
}

TEST(AnalyzeCommand, PutsObserversIntoGroups) {
    const TemporaryFolder folder;
    std::string groups = "observer,sex\n";
    for (int o = 1; o <= 10; ++o)
        groups += std::string(o < 10 ? "O0" : "O") + std::to_string(o) + (o <= 4 ? ",M\n" : ",F\n");
    write_file(folder / "groups.csv", groups);
    const auto out = (folder / "findings.json").string();
    const auto votes = data + "/golden/experiment/votes.csv";
    auto outcome = pairlight(
        {"analyze", votes, "--groups", (folder / "groups.csv").string(), "--json", out, "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto expected = json::parse(read_file(data + "/golden/experiment/expected.json"));
    const auto found = json::parse(read_file(out));
    EXPECT_NEAR(found["anova"]["mixed_sex_method"]["group_x_method"]["F"].get<double>(),
                expected["anova"]["mixed_sex_method"]["group_x_method"]["F"].get<double>(), 1e-12);
    write_file(folder / "few.csv", "observer,sex\nO01,M\n");
    outcome = pairlight({"analyze", votes, "--groups", (folder / "few.csv").string()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("observer 'O02' has no group"));
}

TEST(AnalyzeCommand, NamesTheLineThatIsNoUtf8) {
    const TemporaryFolder folder;
    write_file(folder / "votes.csv", "observer,left,right,chosen\nO1,a,caf\xE9,left\n");
    const auto outcome = pairlight(
        {"analyze", (folder / "votes.csv").string(), "--json", (folder / "out.json").string()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("votes.csv:2: a byte that is no UTF-8"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out.json"));
}

} // namespace
