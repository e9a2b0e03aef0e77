#include "analysis/numerics/nist_file.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

namespace {

using namespace analysis::numerics;

std::string contents(const std::string& name) {
    std::ifstream stream(PAIRLIGHT_TEST_DATA "/nist/" + name);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(NistFile, FindsDataAndCertifiedLinesByTheirWords) {
    // AtmWtAg has its certified lines one lower than the others.
    const auto set = read_nist_one_way(contents("AtmWtAg.dat"), "AtmWtAg.dat");
    ASSERT_TRUE(set) << set.error();
    EXPECT_EQ(set->labels, (std::vector<std::string>{"1", "2"}));
    EXPECT_EQ(set->groups[0].size(), 24u);
    EXPECT_EQ(set->groups[1].size(), 24u);
    EXPECT_TRUE(set->groups[0][0].mantissa == 1078681568);
    EXPECT_EQ(set->groups[0][0].exponent, -7);
    EXPECT_EQ(set->certified.df_between, 1);
    EXPECT_EQ(set->certified.ss_between, 3.63834187500000E-09);
    EXPECT_EQ(set->certified.f, 1.59467335677930E+01);
    EXPECT_EQ(set->certified.df_within, 46);
    EXPECT_EQ(set->certified.ms_within, 2.28155932971014E-10);
    EXPECT_EQ(set->certified.r_squared, 2.57426544538321E-01);
    EXPECT_EQ(set->certified.residual_sd, 1.51048314446410E-05);
}

TEST(NistFile, SaysWhatIsWrongAndWhere) {
    const std::string head =
        "Between Groups 1 2 3 4\nWithin Groups 2 3 4\nCertified R-Squared 0.5\n"
        "Standard Deviation 0.1\nData: Group Value\n";
    const auto error = [](const std::string& text) {
        const auto set = read_nist_one_way(text, "x.dat");
        return set ? std::string("read") : set.error();
    };
    EXPECT_EQ(error(head + "1 2.5\n1 2.75\n2 3\n"), "read");
    EXPECT_EQ(error(""), "x.dat:1: no line starts with 'Data:', expected NIST's text form of an "
                         "ANOVA set");
    EXPECT_EQ(error("Data: a b\n1 2\n"), "x.dat:1: 0 certified lines before the data, expected 4: "
                                         "Between, Within, R-Squared, Standard Deviation");
    EXPECT_EQ(error(head + "1 2.5\n2 3,5\n"),
              "x.dat:7: '3,5', column 2: found ',', expected the end of a number");
    EXPECT_EQ(error(head + "1 2.5 7\n"),
              "x.dat:6: '1 2.5 7' has 3 columns, expected group and value");
    EXPECT_EQ(error(head + "1 2.5\n"), "x.dat:5: 1 groups of data, expected at least 2");
    EXPECT_EQ(error("Between Groups x\n" + head),
              "x.dat:1: 'Between Groups x' line without its certified numbers");
}

} // namespace
