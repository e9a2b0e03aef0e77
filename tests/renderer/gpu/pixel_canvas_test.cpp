#include "renderer/gpu/context.h"
#include "renderer/gpu/pixel_canvas.h"
#include "renderer/gpu/target.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace {

using namespace renderer::gpu;

constexpr int width = 301, height = 67; // odd, so that rows are not aligned by luck

class PixelCanvasTest : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(context_) << context_.error();
        auto target = Target::create(width, height);
        ASSERT_TRUE(target) << target.error();
        target_.emplace(std::move(*target));
        drawing_ = std::unique_ptr<DrawingInto>(new DrawingInto(target_->draw_into()));
    }

    void TearDown() override {
        drawing_.reset();
        target_.reset();
    }

    renderer::Expected<Context> context_ = Context::surfaceless();
    std::optional<Target> target_;
    std::unique_ptr<DrawingInto> drawing_;
    PixelCanvas canvas_{width, height};
};

// Every code value in every channel, and no two pixels of a row alike.
Picture8 all_codes() {
    Picture8 picture{257, 3, {}};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (const int value : {x + y, 255 - x, (x ^ 0x55) + 40 * y})
                picture.rgb.push_back(static_cast<std::uint8_t>(value & 0xff));
    return picture;
}

TEST_F(PixelCanvasTest, ClearsToExactlyTheCodeValue) {
    for (const int code : {0, 1, 127, 128, 188, 255}) {
        canvas_.clear(static_cast<std::uint8_t>(code));
        const auto all = canvas_.read(0, 0, width, height);
        ASSERT_EQ(all.rgb.size(), 3u * width * height);
        EXPECT_TRUE(std::ranges::all_of(all.rgb, [&](int value) { return value == code; })) << code;
    }
}

TEST_F(PixelCanvasTest, KeepsEveryCodeValueOfAPicture) {
    const auto picture = all_codes();
    const UploadedPicture uploaded(picture);
    canvas_.clear(128);
    canvas_.draw(uploaded, 11, 5);
    EXPECT_EQ(canvas_.read(11, 5, picture.width, picture.height), picture);
}

TEST_F(PixelCanvasTest, CountsPixelsFromTheUpperLeftCorner) {
    Picture8 picture{2, 2, {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4}};
    const UploadedPicture uploaded(picture);
    canvas_.clear(128);
    canvas_.draw(uploaded, 7, 3);
    const auto value = [&](int x, int y) { return canvas_.read(x, y, 1, 1).rgb[0]; };
    EXPECT_EQ(value(7, 3), 1);
    EXPECT_EQ(value(8, 3), 2);
    EXPECT_EQ(value(7, 4), 3);
    EXPECT_EQ(value(8, 4), 4);
    for (const auto& [x, y] : {std::pair{6, 3}, {9, 3}, {7, 2}, {7, 5}})
        EXPECT_EQ(value(x, y), 128) << x << ' ' << y;
}

TEST_F(PixelCanvasTest, DrawsUpToTheEdges) {
    const UploadedPicture uploaded(all_codes());
    canvas_.draw(uploaded, width - 257, height - 3);
    EXPECT_EQ(canvas_.read(width - 257, height - 3, 257, 3), all_codes());
}

} // namespace
