#include "protocols/display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace protocols;

Eotf gamma(double exponent) {
    Eotf eotf;
    eotf.kind = Eotf::Kind::Gamma;
    eotf.gamma = exponent;
    return eotf;
}

TEST(Eotf, GivesTheLightOfTheMiddleCode) {
    // 128/255 = 0.50196: sRGB ((0.50196 + 0.055) / 1.055)^2.4 = 0.21586, 0.50196^2.2 = 0.21952,
    // 0.50196^2.4 = 0.19125.
    EXPECT_NEAR(relative_luminance({}, 128), 0.21586, 5e-6);
    EXPECT_NEAR(relative_luminance(gamma(2.2), 128), 0.21952, 5e-6);
    EXPECT_NEAR(relative_luminance(gamma(2.4), 128), 0.19125, 5e-6);
}

TEST(Eotf, BeginsAtBlackEndsAtWhiteAndRises) {
    Eotf table;
    table.kind = Eotf::Kind::Measured;
    table.steps = {{0, 0.1}, {128, 20}, {255, 100}};
    EXPECT_EQ(relative_luminance(table, 0), 0.001);
    EXPECT_DOUBLE_EQ(relative_luminance(table, 64), (0.1 + 20) / 2 / 100);
    for (const auto& eotf : {Eotf{}, gamma(2.2), table}) {
        EXPECT_EQ(relative_luminance(eotf, 255), 1);
        for (int code = 1; code <= 255; ++code)
            EXPECT_GT(relative_luminance(eotf, code), relative_luminance(eotf, code - 1));
    }
}

TEST(Surround, IsACodeALightnessOrALight) {
    EXPECT_EQ(surround_of("code:128", {})->code, 128);
    EXPECT_EQ(surround_of("lstar:50", {})->code, 119);
    EXPECT_EQ(surround_of("linear:0.5", {})->code, 188);
    // 255 * 0.5^(1/2.2) = 186.1
    EXPECT_EQ(surround_of("linear:0.5", gamma(2.2))->code, 186);
    EXPECT_EQ(surround_of("linear:1", {})->code, 255);
    for (const auto* wrong : {"", "128", "code:", "code:256", "code:1.5", "lstar:101", "linear:-1",
                              "grey:5", "linear:nan"})
        EXPECT_EQ(surround_of(wrong, {}), std::nullopt) << wrong;
}

TEST(ViewingDistance, OfOneArcMinuteAPixelIsSixtyPixelsADegree) {
    // 1/60 degree of a circle of radius 1000 mm is 0.290888 mm.
    EXPECT_NEAR(pixels_per_degree(1000, 0.290888), 60, 1e-4);
}

TEST(Room, TellsOnlyWhatIsRecorded) {
    EXPECT_EQ(text_of(Room{}), "");
    Room room;
    room.black_ratio = 0.01;
    room.background_white = "D65";
    EXPECT_EQ(text_of(room), "black_ratio=0.01; background_white=D65");
}

} // namespace
