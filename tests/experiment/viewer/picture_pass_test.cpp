// The shader against its slow twins, code value by code value.
#include "experiment/viewer/false_colours.h"
#include "experiment/viewer/picture_pass.h"
#include "renderer/gpu/context.h"
#include "renderer/gpu/pixel_canvas.h"
#include "renderer/imaging/colour.h"

#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace {

using namespace experiment::viewer;
namespace gpu = renderer::gpu;

constexpr int width = 256, height = 2;

// What the rows of pixels are painted with: a function of the column.
constexpr const char* ramp = R"(
out vec4 colour;
void main() {
    float t = floor(gl_FragCoord.x) / 255.0;
    PAINT
}
)";

class PicturePassTest : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(context_) << context_.error();
        for (auto* target : {&left_, &right_, &screen_})
            target->emplace(*gpu::Target::create(width, height));
        auto pass = PicturePass::create();
        ASSERT_TRUE(pass) << pass.error();
        pass_.emplace(std::move(*pass));
    }

    void TearDown() override {
        pass_.reset();
        for (auto* target : {&left_, &right_, &screen_})
            target->reset();
    }

    static void paint(const gpu::Target& target, const std::string& what) {
        std::string text = ramp;
        text.replace(text.find("PAINT"), 5, what);
        const std::array fragment{gpu::ShaderPart{"ramp", text}};
        const auto pass = gpu::ScreenPass::link(fragment);
        ASSERT_TRUE(pass) << pass.error();
        const auto drawing = target.draw_into();
        pass->run({0, 0, width, height});
    }

    gpu::Picture8 shown(Composition composition) {
        composition.place = {0, 0, width, height};
        const auto drawing = screen_->draw_into();
        pass_->draw(*left_, *right_, composition);
        return gpu::PixelCanvas(width, height).read(0, 0, width, height);
    }

    static std::array<int, 3> pixel(const gpu::Picture8& picture, int column) {
        const auto* code = &picture.rgb[static_cast<std::size_t>(3 * column)];
        return {code[0], code[1], code[2]};
    }

    renderer::Expected<gpu::Context> context_ = gpu::Context::surfaceless();
    std::optional<gpu::Target> left_, right_, screen_;
    std::optional<PicturePass> pass_;
};

int code(double light) {
    return renderer::imaging::code_8bit(renderer::imaging::srgb_from_linear(light));
}

// A rasteriser's pow moves only a value that lies on the edge of two codes.
void expect_codes(const std::array<int, 3>& codes, const renderer::LinearRgb& light) {
    EXPECT_NEAR(codes[0], code(static_cast<double>(light.r)), 1);
    EXPECT_NEAR(codes[1], code(static_cast<double>(light.g)), 1);
    EXPECT_NEAR(codes[2], code(static_cast<double>(light.b)), 1);
}

TEST_F(PicturePassTest, EncodesLightOnceByTheExactCurve) {
    paint(*left_, "colour = vec4(t, 0.25 * t, 4.0 * t, 1.0);");
    const auto picture = shown({});
    int off = 0;
    for (int x = 0; x < width; ++x) {
        const double t = x / 255.0;
        const auto codes = pixel(picture, x);
        off += codes[0] != code(t);
        off += codes[1] != code(0.25 * t);
        off += codes[2] != code(4 * t);
        expect_codes(codes, {static_cast<float>(t), static_cast<float>(0.25 * t),
                             static_cast<float>(4 * t)});
    }
    // A rasteriser's pow may be off by 1e-5; of 768 values so many lie that near to an edge:
    // 768 * 2 * 255 * 1e-5 = 4.
    EXPECT_LE(off, 12);
}

TEST_F(PicturePassTest, PutsThePictureOverItsSurround) {
    left_->clear();
    const auto picture = shown({.surround = 137});
    for (const int channel : pixel(picture, 77))
        EXPECT_EQ(channel, 137);
}

TEST_F(PicturePassTest, SplitsWhereItIsTold) {
    paint(*left_, "colour = vec4(1.0, 0.0, 0.0, 1.0);");
    paint(*right_, "colour = vec4(0.0, 0.0, 1.0, 1.0);");
    const auto picture = shown({.right_from = 0.25});
    EXPECT_EQ(pixel(picture, 63), (std::array{255, 0, 0}));
    EXPECT_EQ(pixel(picture, 64), (std::array{0, 0, 255}));
    const auto lined = shown({.right_from = 0.25, .line = true});
    EXPECT_EQ(pixel(lined, 63)[1], code(0.9));
    EXPECT_EQ(pixel(lined, 64)[1], code(0.9));
    EXPECT_EQ(pixel(lined, 62), (std::array{255, 0, 0}));
    EXPECT_EQ(pixel(lined, 65), (std::array{0, 0, 255}));
}

// Thickness 100 t under a light that grows with it; the scale ends at 50.  The palette has 256
// entries, so the twin may stand in the neighbouring one, which is up to 2 codes away.
TEST_F(PicturePassTest, ReadsThicknessOutOfTheProbesPicture) {
    paint(*left_, "colour = vec4((1.0 + 3.0 * t) * exp(-vec3(1.0, 2.0, 3.0) * t), 1.0);");
    const auto picture =
        shown({.look = Look::Thickness, .whole = 50, .reach = renderer::Millimetres{100}});
    std::vector<float> rgba;
    left_->read(rgba);
    for (int x = 0; x < width; ++x) {
        const std::span<const float, 4> probe(&rgba[static_cast<std::size_t>(4 * x)], 4);
        const auto d = thickness_of(probe, renderer::Millimetres{100});
        ASSERT_TRUE(d) << x;
        EXPECT_NEAR(*d, 100 * x / 255.0, 0.01); // 100 mm of a rasteriser's exp, 5e-5 twice
        const auto colour = false_colour(*d / 50);
        const auto codes = pixel(picture, x);
        EXPECT_NEAR(codes[0], code(static_cast<double>(colour.r)), 2) << x;
        EXPECT_NEAR(codes[1], code(static_cast<double>(colour.g)), 2) << x;
        EXPECT_NEAR(codes[2], code(static_cast<double>(colour.b)), 2) << x;
    }
}

TEST_F(PicturePassTest, StripesWhereThereIsNoThickness) {
    paint(*left_, "colour = vec4(0.5, 0.5, 0.1, 1.0);");
    const auto picture = shown({.look = Look::Thickness});
    EXPECT_EQ(pixel(picture, 3)[0], code(0.10));
    EXPECT_EQ(pixel(picture, 9)[0], code(0.16));
}

TEST_F(PicturePassTest, ShowsTheLargestDifferenceWhicheverSideItIsOn) {
    paint(*left_, "colour = vec4(0.5, 0.2 * t, 0.3, 1.0);");
    paint(*right_, "colour = vec4(0.5, 0.0, 0.3, 1.0);");
    for (int turn = 0; turn < 2; ++turn) {
        const auto picture = shown({.look = Look::Error, .whole = 0.2});
        for (const int x : {0, 51, 128, 255}) {
            const auto colour = false_colour(x / 255.0);
            EXPECT_NEAR(pixel(picture, x)[0], code(static_cast<double>(colour.r)), 2) << x;
            EXPECT_NEAR(pixel(picture, x)[2], code(static_cast<double>(colour.b)), 2) << x;
        }
        std::swap(left_, right_);
    }
}

} // namespace
