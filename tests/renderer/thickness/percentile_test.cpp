#include "renderer/thickness/percentile.h"

#include <limits>

namespace {

using renderer::thickness::LengthHistogram;

TEST(LengthHistogram, PercentilesOfAUniformStreamAreItsFractions) {
    LengthHistogram histogram;
    const int count = 100000;
    for (int i = 0; i < count; ++i)
        histogram.add((static_cast<float>(i) + 0.5f) / count, 1);
    // bins of 1/256 of an octave with 100 to 200 samples each, interpolated: one sample's error
    for (const double fraction : {0.1, 0.25, 0.5, 0.9, 0.995})
        EXPECT_NEAR(histogram.percentile(fraction), fraction, 2e-5);
}

TEST(LengthHistogram, WeighsWhatItCounts) {
    LengthHistogram histogram;
    histogram.add(0.25f, 3);
    histogram.add(0.75f, 1);
    EXPECT_NEAR(histogram.percentile(0.75), 0.25, 0.25 / 256); // a bin's width
    EXPECT_NEAR(histogram.percentile(0.8), 0.75, 0.75 / 256);
}

TEST(LengthHistogram, CountsNothingThatHasNoLength) {
    LengthHistogram histogram;
    histogram.add(0, 5);
    histogram.add(-1, 5);
    histogram.add(std::numeric_limits<float>::quiet_NaN(), 5);
    EXPECT_EQ(histogram.percentile(0.995), 0);
    histogram.add(0.5f, 1);
    EXPECT_NEAR(histogram.percentile(0.5), 0.5, 0.5 / 256);
}

TEST(LengthHistogram, KeepsTinyAndHugeLengthsInItsRange) {
    LengthHistogram histogram;
    histogram.add(1e-9f, 1);
    EXPECT_NEAR(histogram.percentile(1), 1e-9, 1e-9 / 128);
    histogram.add(1e9f,
                  1000); // more than two diameters does not happen; it must not write elsewhere
    EXPECT_NEAR(histogram.percentile(0.995), 2, 0.01);
}

TEST(LengthHistogram, IsTheSumOfItsParts) {
    LengthHistogram whole, even, odd;
    for (int i = 1; i < 1000; ++i) {
        const float length = 1.0f / static_cast<float>(i);
        whole.add(length, static_cast<std::uint64_t>(i));
        (i % 2 == 0 ? even : odd).add(length, static_cast<std::uint64_t>(i));
    }
    even += odd;
    EXPECT_EQ(even.percentile(0.3), whole.percentile(0.3));
}

} // namespace
