#include "experiment/session/pair_layout.h"

namespace {

using experiment::session::lay_out_pair;
using experiment::session::PairLayout;
using testing::HasSubstr;

TEST(PairLayout, HasEqualMarginsAndOneCentreLine) {
    const auto layout = lay_out_pair(1280, 800, 300, 200, 32);
    ASSERT_TRUE(layout);
    EXPECT_EQ(*layout, (PairLayout{324, 656, 300, 300, 200}));
    EXPECT_EQ(layout->left_x, 1280 - (layout->right_x + layout->width));
    EXPECT_EQ(layout->right_x - (layout->left_x + layout->width), 32);
}

TEST(PairLayout, FillsTheScreenWhenItMust) {
    EXPECT_EQ(*lay_out_pair(1312, 640, 640, 640, 32), (PairLayout{0, 672, 0, 640, 640}));
}

TEST(PairLayout, RefusesPicturesThatDoNotFit) {
    EXPECT_THAT(lay_out_pair(1311, 640, 640, 640, 32).error(),
                HasSubstr("need 1312 x 640 pixels, but the screen has 1311 x 640"));
    EXPECT_FALSE(lay_out_pair(1312, 639, 640, 640, 32));
}

} // namespace
