// Lines, fields and numbers of text files.
#include "renderer/geometry/text_fields.h"

#include <cmath>

namespace {

using namespace renderer::geometry;

std::vector<std::string> all_lines(std::string_view text) {
    Lines lines(text);
    std::vector<std::string> all;
    while (const auto line = lines.next())
        all.emplace_back(*line);
    EXPECT_EQ(lines.number(), all.size());
    return all;
}

TEST(Lines, EndAsTheFirstOneDoes) {
    const std::vector<std::string> expected{"one", "", "three"};
    EXPECT_EQ(all_lines("one\n\nthree\n"), expected);
    EXPECT_EQ(all_lines("one\n\nthree"), expected);
    EXPECT_EQ(all_lines("one\r\n\r\nthree\r\n"), expected);
    EXPECT_EQ(all_lines("one\r\rthree"), expected);
    EXPECT_TRUE(all_lines("").empty());
}

TEST(SplitFields, TakesBlanksAndTabsInAnyNumber) {
    std::vector<std::string_view> fields{"old"};
    split_fields("  a \t bc  ", fields);
    EXPECT_THAT(fields, testing::ElementsAre("a", "bc"));
    split_fields(" \t ", fields);
    EXPECT_TRUE(fields.empty());
}

TEST(ParseReal, TakesTheWholeFieldOrNothing) {
    EXPECT_EQ(parse_real("-1.5e3"), -1500);
    EXPECT_EQ(parse_real("+.5"), 0.5);
    EXPECT_EQ(parse_real("0.1"), 0.1); // to the last bit
    EXPECT_TRUE(std::isnan(parse_real("nan").value()));
    for (const auto* field : {"", "+", "1,5", "1x", "one", "1e999", "0x10"})
        EXPECT_FALSE(parse_real(field)) << field;
}

TEST(ParseCount, TakesWholeNumbersOnly) {
    EXPECT_EQ(parse_count("18446744073709551615"), 18446744073709551615u);
    for (const auto* field : {"", "-1", "+1", "1.0", "18446744073709551616"})
        EXPECT_FALSE(parse_count(field)) << field;
}

TEST(Shown, IsShortAndPrintable) {
    EXPECT_EQ(shown("a\x01 b\xff"), "'a? b?'");
    EXPECT_EQ(shown(std::string(100, 'x')), "'" + std::string(24, 'x') + "...'");
}

} // namespace
