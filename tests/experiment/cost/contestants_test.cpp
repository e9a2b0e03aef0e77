#include "experiment/cost/contestants.h"

#include <algorithm>

namespace {

using namespace experiment::cost;
using testing::HasSubstr;

TEST(CostSettings, AreThePresetsAndTheSweepUnderOneLaw) {
    const auto settings = settings_of({.methods = {"shss", "phong"}, .law = "paper"});
    ASSERT_TRUE(settings);
    EXPECT_EQ(settings->front().words, "");
    EXPECT_EQ(settings->back().method->name, "phong");
    EXPECT_EQ(settings->back().words, "triangles 1/8");
    const auto found = std::ranges::find(*settings, "bands 2, coefficients int8", &Setting::words);
    ASSERT_NE(found, settings->end());
    EXPECT_EQ(renderer::methods::name_in(found->dials, "law"), "paper");
    EXPECT_EQ(settings_of({.methods = {"shss", "phong"}, .presets_only = true})->size(), 2U);
    EXPECT_GT(settings_of({})->size(), 80U);
}

TEST(CostSettings, AreThePresetsOnEverySimplifiedMesh) {
    const auto settings = settings_of({.methods = {"shss"}, .one_of = {1, 4, 8}});
    const auto preset = settings_of({.methods = {"shss"}, .presets_only = true})->front();
    std::vector<int> levels;
    for (const auto& setting : *settings)
        if (setting.one_of != 1) {
            levels.push_back(setting.one_of);
            EXPECT_EQ(setting.dials, preset.dials);
            EXPECT_EQ(setting.words, level_words(setting.one_of));
        }
    EXPECT_THAT(levels, testing::ElementsAre(4, 8));
}

TEST(CostSettings, SayWhichNameIsNotOne) {
    const auto settings = settings_of({.methods = {"shs"}});
    ASSERT_FALSE(settings);
    EXPECT_THAT(settings.error(),
                HasSubstr("--methods shs: no method is called so; there are shss"));
}

} // namespace
