#include "renderer/gpu/context.h"
#include "renderer/gpu/screen_pass.h"
#include "renderer/gpu/target.h"

#include <fmt/format.h>

#include <array>

namespace {

using renderer::gpu::LayeredMap;
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

TEST_F(TargetTest, ALayeredMapCanBeDrawnIntoBesideIt) {
    const auto target = Target::create(4, 4);
    const auto map = LayeredMap::create(64, 2, LayeredMap::Reading::Nearest);
    ASSERT_TRUE(target && map);
    {
        const auto outer = target->draw_into();
        const auto inner = map->draw_into(1);
        EXPECT_EQ(renderer::gpu::bound_viewport().width, 64);
    }
    EXPECT_EQ(map->bytes(), 64U * 64U * 2U * 4U);
    EXPECT_TRUE(renderer::gpu::check("drawing into two"));
}

// Every layer adds 1 to the one before it.
TEST_F(TargetTest, ALayerCanBeMadeFromTheOneBefore) {
    const auto map = LayeredMap::create(8, 3, LayeredMap::Reading::Nearest);
    ASSERT_TRUE(map) << map.error();
    for (int layer = 0; layer < 3; ++layer) {
        const auto text = fmt::format("layout(binding = 0) uniform sampler2DArray layers;\n"
                                      "out float value;\n"
                                      "void main() {{ value = 1.0 + ({0} == 0 ? 0.0 : texelFetch("
                                      "layers, ivec3(gl_FragCoord.xy, {0} - 1), 0).r); }}",
                                      layer);
        const std::array parts{renderer::gpu::ShaderPart{"one more", text}};
        const auto pass = renderer::gpu::ScreenPass::link(parts);
        ASSERT_TRUE(pass) << pass.error();
        map->bind_texture(0);
        const auto drawing = map->draw_into(layer);
        pass->run();
    }
    const auto values = map->read();
    ASSERT_EQ(values.size(), 3U * 64U);
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_EQ(values[i], static_cast<float>(1 + i / 64)) << i;
}

} // namespace
