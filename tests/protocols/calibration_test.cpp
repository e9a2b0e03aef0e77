#include "protocols/calibration.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace protocols;
using testing::HasSubstr;

/// Measurements of a display that follows the model exactly.
std::string measured(double black, double white, double gamma) {
    std::string csv = "code,cd_m2\n";
    for (const int code : photometer_codes())
        csv += fmt::format("{},{:.12f}\n", code,
                           black + (white - black) * std::pow(code / 255.0, gamma));
    return csv;
}

TEST(Photometer, FindsTheGammaThatMadeTheMeasurements) {
    for (const double gamma : {1.8, 2.2, 2.4}) {
        const auto steps = parse_photometer(measured(0.2, 120, gamma), "c.csv");
        ASSERT_TRUE(steps) << steps.error();
        const auto fit = fit_gamma(*steps);
        EXPECT_NEAR(fit.gamma, gamma, 2e-6); // the search ends at 1e-6
        EXPECT_EQ(fit.black_cd_m2, 0.2);
        EXPECT_EQ(fit.white_cd_m2, 120);
        EXPECT_LE(fit.worst_residual, 1e-6);
    }
}

TEST(Photometer, SeesThatACurveIsNoGamma) {
    std::string csv = "code,cd_m2\n"; // a straight line up to the middle, steep above
    for (const int code : photometer_codes())
        csv +=
            fmt::format("{},{}\n", code, code <= 128 ? 0.1 + code * 0.5 : 64.1 + (code - 128) * 2);
    const auto steps = parse_photometer(csv, "c.csv");
    ASSERT_TRUE(steps) << steps.error();
    EXPECT_GT(fit_gamma(*steps).worst_residual, 0.05);
}

TEST(Photometer, TakesTheGreysOfATableOfColours) {
    std::string csv = "code_r,code_g,code_b,X,Y,Z\n";
    for (const int code : photometer_codes())
        csv += fmt::format("{0},{0},{0},1,{1},1\n", code, code + 1);
    csv += "255,0,0,40,20,2\n# a remark\n\n";
    const auto steps = parse_photometer(csv, "c.csv");
    ASSERT_TRUE(steps) << steps.error();
    EXPECT_EQ(steps->size(), photometer_codes().size());
    EXPECT_EQ(steps->back(), (GreyStep{255, 256}));
}

TEST(Photometer, SaysWhatIsWrongWithMeasurements) {
    const auto error = [](const std::string& csv) {
        const auto steps = parse_photometer(csv, "c.csv");
        return steps ? std::string("it was read") : steps.error();
    };
    const auto whole = measured(0.2, 120, 2.2);
    EXPECT_THAT(error("grey,light\n"), HasSubstr("c.csv:1: columns \"grey,light\""));
    EXPECT_THAT(error("code,cd_m2\n0,dark\n"),
                HasSubstr("c.csv:2: \"dark\", expected a luminance"));
    EXPECT_THAT(error("code,cd_m2\n300,1\n"), HasSubstr("expected a code value of 0 to 255"));
    EXPECT_THAT(error("code,cd_m2\n0,nan\n"), HasSubstr("expected a luminance"));
    EXPECT_THAT(error("code,cd_m2\n0,1\n255,2\n"), HasSubstr("2 greys, expected at least 9"));
    EXPECT_THAT(error(whole + "255,121\n"), HasSubstr("code 255 comes twice"));
    EXPECT_THAT(error(whole + "254,121\n"), HasSubstr("code 255 is not lighter than code 254"));
    EXPECT_EQ(error(std::string("code,cd_m2\n0,\0001\n", 16)),
              "c.csv:2: a zero byte; save the file as text");
}

TEST(Photometer, ReadsWhatSpreadsheetsWrite) {
    std::string text = "\xEF\xBB\xBF";
    for (const char c : measured(0.2, 120, 2.2))
        text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const auto steps = parse_photometer(text, "c.csv");
    ASSERT_TRUE(steps) << steps.error();
    EXPECT_EQ(*steps, parse_photometer(measured(0.2, 120, 2.2), "c.csv").value());
}

} // namespace
