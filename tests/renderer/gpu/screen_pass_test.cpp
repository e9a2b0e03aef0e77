#include "renderer/gpu/context.h"
#include "renderer/gpu/screen_pass.h"
#include "renderer/gpu/target.h"

#include <array>
#include <vector>

namespace {

using namespace renderer::gpu;

TEST(ScreenPass, WritesItsRectangleAndNothingElse) {
    const auto context = Context::surfaceless();
    ASSERT_TRUE(context) << context.error();
    const auto target = Target::create(9, 7);
    ASSERT_TRUE(target) << target.error();
    target->clear();
    const std::array fragment{ShaderPart{
        "place", "out vec4 colour; void main() { colour = vec4(gl_FragCoord.xy, 7.0, 1.0); }"}};
    const auto pass = ScreenPass::link(fragment);
    ASSERT_TRUE(pass) << pass.error();
    {
        const auto drawing = target->draw_into();
        pass->run({2, 1, 4, 5});
    }
    std::vector<float> rgba;
    target->read(rgba);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x) {
            const bool inside = x >= 2 && x < 6 && y >= 1 && y < 6;
            const auto* pixel = &rgba[static_cast<std::size_t>(4 * (9 * y + x))];
            EXPECT_EQ(pixel[3], inside ? 1 : 0) << x << ' ' << y;
            if (inside) {
                EXPECT_EQ(pixel[0], static_cast<float>(x) + 0.5F); // from the frame buffer's corner
                EXPECT_EQ(pixel[1], static_cast<float>(y) + 0.5F);
            }
        }
}

TEST(ScreenPass, ReportsTheDriversLog) {
    const auto context = Context::surfaceless();
    ASSERT_TRUE(context) << context.error();
    const std::array fragment{ShaderPart{"broken", "void main() { nonsense }"}};
    const auto pass = ScreenPass::link(fragment);
    ASSERT_FALSE(pass);
    EXPECT_THAT(pass.error(), testing::HasSubstr("broken"));
}

} // namespace
