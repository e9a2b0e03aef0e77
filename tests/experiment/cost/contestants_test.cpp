#include "experiment/cost/contestants.h"

#include <algorithm>

namespace {

using namespace experiment::cost;
using testing::HasSubstr;

TEST(CostSettings, AreThePresetsAndTheSweepUnderOneLaw) {
    const auto settings = settings_of({"shss", "phong"}, "paper", false);
    ASSERT_TRUE(settings);
    EXPECT_EQ(settings->front().words, "");
    EXPECT_EQ(settings->back().method->name, "phong");
    const auto found = std::ranges::find(*settings, "bands 2, coefficients int8", &Setting::words);
    ASSERT_NE(found, settings->end());
    EXPECT_EQ(renderer::methods::name_in(found->dials, "law"), "paper");
    EXPECT_EQ(settings_of({"shss", "phong"}, "paper", true)->size(), 2U);
    EXPECT_GT(settings_of({}, "physical", false)->size(), 40U);
}

TEST(CostSettings, SayWhichNameIsNotOne) {
    const auto settings = settings_of({"shs"}, "paper", false);
    ASSERT_FALSE(settings);
    EXPECT_THAT(settings.error(),
                HasSubstr("--methods shs: no method is called so; there are shss"));
}

} // namespace
