#include "renderer/gpu/context.h"
#include "renderer/gpu/target.h"

namespace {

using renderer::gpu::DepthMap;
using renderer::gpu::Target;

class TargetTest : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(context_) << context_.error(); }

    renderer::Expected<renderer::gpu::Context> context_ = renderer::gpu::Context::surfaceless();
};

TEST_F(TargetTest, IsBlackAndTransparentWhenCleared) {
    const auto target = Target::create(5, 3);
    ASSERT_TRUE(target) << target.error();
    target->clear();
    std::vector<float> rgba;
    target->read(rgba);
    EXPECT_EQ(rgba, std::vector<float>(5 * 3 * 4, 0.0F));
}

TEST_F(TargetTest, NamesTheSizesItCanHave) {
    for (const auto& [width, height] : {std::pair(0, 4), std::pair(4, -1), std::pair(1 << 24, 4)}) {
        const auto target = Target::create(width, height);
        ASSERT_FALSE(target);
        EXPECT_THAT(target.error(), testing::ContainsRegex("texels, expected 1 to [0-9]+ along"));
    }
}

TEST_F(TargetTest, ADepthMapCanBeDrawnIntoBesideIt) {
    const auto target = Target::create(4, 4);
    const auto map = DepthMap::create(64);
    ASSERT_TRUE(target && map);
    {
        const auto outer = target->draw_into();
        const auto inner = map->draw_into();
        map->clear();
    }
    EXPECT_EQ(map->resolution(), 64);
    EXPECT_TRUE(renderer::gpu::check("drawing into two"));
}

} // namespace
