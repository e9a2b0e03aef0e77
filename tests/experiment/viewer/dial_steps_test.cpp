#include "experiment/viewer/dial_steps.h"

namespace {

using experiment::viewer::stepped;
using renderer::methods::Dial;
using renderer::methods::DialRange;
using renderer::methods::DialValue;

DialValue whole(std::int64_t value) {
    return value;
}

const Dial bands{.name = "bands", .preset = whole(5), .whole = DialRange<std::int64_t>{1, 6}};
const Dial directions{
    .name = "directions", .preset = whole(1024), .whole = DialRange<std::int64_t>{1, 65536}};
const Dial law{.name = "law", .preset = "physical", .names = {"paper", "physical"}};
const Dial wide{.name = "mm", .preset = 10.0, .number = DialRange<double>{0, 1e6}};
const Dial narrow{.name = "share", .preset = 0.5, .number = DialRange<double>{0, 1}};
const Dial mixed{.name = "bands",
                 .preset = "auto",
                 .whole = DialRange<std::int64_t>{1, 6},
                 .names = {"auto", "paper"}};

TEST(DialSteps, GoByOneWithinANarrowRangeAndStayAtItsEnds) {
    EXPECT_EQ(stepped(bands, whole(5), 1), whole(6));
    EXPECT_EQ(stepped(bands, whole(6), 1), whole(6));
    EXPECT_EQ(stepped(bands, whole(2), -1), whole(1));
    EXPECT_EQ(stepped(bands, whole(1), -1), whole(1));
}

TEST(DialSteps, DoubleAndHalveAWideRange) {
    EXPECT_EQ(stepped(directions, whole(1024), 1), whole(2048));
    EXPECT_EQ(stepped(directions, whole(1024), -1), whole(512));
    EXPECT_EQ(stepped(directions, whole(40000), 1), whole(65536));
    EXPECT_EQ(stepped(directions, whole(1), -1), whole(1));
}

TEST(DialSteps, GoRoundAmongNames) {
    EXPECT_EQ(stepped(law, "paper", 1), DialValue("physical"));
    EXPECT_EQ(stepped(law, "physical", 1), DialValue("paper"));
    EXPECT_EQ(stepped(law, "paper", -1), DialValue("physical"));
}

TEST(DialSteps, GoFromTheLastNameToTheLeastNumberAndBack) {
    EXPECT_EQ(stepped(mixed, "auto", 1), DialValue("paper"));
    EXPECT_EQ(stepped(mixed, "paper", 1), whole(1));
    EXPECT_EQ(stepped(mixed, whole(1), -1), DialValue("paper"));
    EXPECT_EQ(stepped(mixed, "auto", -1), DialValue("auto"));
    EXPECT_EQ(stepped(mixed, whole(6), 1), whole(6));
}

TEST(DialSteps, ScaleANumberOfManyMagnitudesAndReachItsEnd) {
    EXPECT_EQ(stepped(wide, 10.0, 1), DialValue(12.5));
    EXPECT_EQ(stepped(wide, 12.5, -1), DialValue(10.0));
    DialValue value = 10.0;
    for (int i = 0; i < 50; ++i) // 1.25^-32 is below a thousandth
        value = stepped(wide, value, -1);
    EXPECT_EQ(value, DialValue(0.0));
    EXPECT_DOUBLE_EQ(std::get<double>(stepped(wide, 0.0, 1)), 0.01);
    EXPECT_EQ(stepped(wide, 1e6, 1), DialValue(1e6));
}

TEST(DialSteps, CrossANarrowRangeInTwentySteps) {
    DialValue value = 0.0;
    for (int i = 0; i < 20; ++i)
        value = stepped(narrow, value, 1);
    EXPECT_NEAR(std::get<double>(value), 1, 1e-12); // twenty roundings
    EXPECT_EQ(stepped(narrow, 1.0, 1), DialValue(1.0));
}

} // namespace
