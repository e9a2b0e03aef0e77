#include "renderer/scene.h"

namespace {

// Marble's green channel, sigma_s' = 2.62 and sigma_a = 0.0041 per mm: l_d = 1/sigma_tr = 5.57 mm
// [Jensen2001].
TEST(Medium, EffectiveTransportGivesMarblesDiffusionLength) {
    const renderer::Medium marble{
        .sigma_a = {0.0021, 0.0041, 0.0071}, .sigma_s_reduced = {2.19, 2.62, 3.00}, .index = 1.5};
    EXPECT_NEAR(1.0 / renderer::effective_transport(marble).g, 5.57,
                0.005); // printed to three digits
}

TEST(Medium, WithoutAbsorptionLightIsNeverAttenuated) {
    const renderer::Medium snow{.sigma_a = {0, 0, 0}, .sigma_s_reduced = {11.6, 20.4, 14.9}};
    EXPECT_EQ(renderer::effective_transport(snow), (renderer::RgbPerMillimetre{0, 0, 0}));
}

} // namespace
