// The viewer from outside: in a window under a virtual screen, and without a display.
#include "renderer/geometry/bodies.h"
#include "renderer/imaging/image_files.h"
#include "renderer/methods/catalogue.h"
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/virtual_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace {

using namespace tests;
using renderer::imaging::EncodedImage;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

// 642 vertices: traced in a moment.
void write_ball(const std::filesystem::path& file) {
    const auto ball = renderer::geometry::sphere(1, 3);
    auto text = fmt::format("OFF\n{} {} 0\n", ball.positions.size(), ball.triangles.size());
    for (const auto& p : ball.positions)
        text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    for (const auto& [a, b, c] : ball.triangles)
        text += fmt::format("3 {} {} {}\n", a, b, c);
    write_file(file, text);
}

/// Keys that choose a method for a model by itself: back from the first, through the last.
std::vector<std::string> keys_to(std::string_view method) {
    const auto all = renderer::methods::catalogue();
    const auto found = std::ranges::find(all, method, &renderer::methods::Description::name);
    std::vector<std::string> keys{"1"};
    keys.resize(1 + static_cast<std::size_t>(all.end() - found), "Shift+M");
    return keys;
}

int code(const EncodedImage& image, int x, int y, int channel) {
    return image.codes[static_cast<std::size_t>(3 * (y * image.width + x) + channel)];
}

/// How different two pixels are: the largest channel's difference in codes.
int apart(const EncodedImage& image, int x1, int x2, int y) {
    int most = 0;
    for (int channel = 0; channel < 3; ++channel)
        most = std::max(most, std::abs(code(image, x1, y, channel) - code(image, x2, y, channel)));
    return most;
}

// The picture lies right of the panel, 320 pixels wide; its middle is where the sphere's is.
constexpr int middle_x = (320 + 1280) / 2, middle_y = 400;

/// Across the line in the middle of a split picture.
int across_the_line(const EncodedImage& image) {
    return apart(image, middle_x - 6, middle_x + 6, middle_y);
}

/// Different colours on the sphere's middle row.
std::size_t colours_in_the_middle(const EncodedImage& image) {
    std::set<std::array<int, 3>> colours;
    for (int x = middle_x - 300; x < middle_x + 300; ++x)
        colours.insert({code(image, x, middle_y, 0), code(image, x, middle_y, 1),
                        code(image, x, middle_y, 2)});
    return colours.size();
}

class ViewerWindow : public testing::Test {
  protected:
    void SetUp() override {
        write_ball(folder / "ball.off");
        program = std::make_unique<RunningProgram>(
            std::vector<std::string>{"env", "-C", folder.path().string(), PAIRLIGHT_PROGRAM, "view",
                                     "ball.off", "--diameter", "10"}, // thin enough to glow
            folder / "stderr");
    }

    /// Photographs the screen until it shows what it should.
    template <class Shows>
    testing::AssertionResult comes_to_show(Shows shows) {
        const auto deadline = Clock::now() + std::chrono::seconds(60);
        while (program->is_running() && Clock::now() < deadline)
            if (shows(screen.photograph()))
                return testing::AssertionSuccess();
        return testing::AssertionFailure()
               << "the viewer did not come to show it; it said: " << read_file(folder / "stderr");
    }

    void choose(std::string_view method) {
        for (const auto& key : keys_to(method))
            screen.press(key == "Shift+M" ? "shift+m" : key);
    }

    TemporaryFolder folder;
    VirtualScreen screen{1280, 800};
    std::unique_ptr<RunningProgram> program;
};

TEST_F(ViewerWindow, IsDrivenByKeysAlone) {
    // Grey around the ball, something brighter or darker than that in its middle.
    ASSERT_TRUE(comes_to_show([](const EncodedImage& image) {
        return code(image, 1270, 790, 0) == 128 && colours_in_the_middle(image) > 20;
    }));

    choose("constant");
    screen.press("Tab");
    choose("phong");
    ASSERT_TRUE(comes_to_show(
        [](const EncodedImage& image) { return across_the_line(image) <= 3; })); // Phong alone
    screen.press("s");
    EXPECT_TRUE(
        comes_to_show([](const EncodedImage& image) { return across_the_line(image) > 20; }));

    screen.press("e"); // what differs is the same on both sides of where the line was
    EXPECT_TRUE(comes_to_show([](const EncodedImage& image) {
        return across_the_line(image) <= 3 && code(image, middle_x, middle_y, 0) > 40;
    }));

    screen.press("p");
    const auto png = folder / "ball-001.png";
    const auto deadline = Clock::now() + std::chrono::seconds(60);
    while (Clock::now() < deadline && !std::filesystem::exists(folder / "ball-001-right.exr"))
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const auto picture = renderer::imaging::read_encoded(png);
    ASSERT_TRUE(picture) << picture.error();
    EXPECT_EQ(picture->image.width, 1280);
    EXPECT_TRUE(renderer::imaging::read_exr(folder / "ball-001-left.exr"));

    screen.press("Escape");
    const auto end = Clock::now() + std::chrono::seconds(30);
    while (program->is_running() && Clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ASSERT_FALSE(program->is_running());
    EXPECT_EQ(program->status(), 0) << read_file(folder / "stderr");
}

Outcome view_without_display(std::vector<std::string> arguments) {
    std::vector<std::string> command{"env", "-u", "DISPLAY", PAIRLIGHT_PROGRAM, "view"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run(command);
}

/// The ball's thickness as the method has it.
Outcome
take_picture(const TemporaryFolder& folder, std::string_view method, const std::string& file) {
    write_ball(folder / "ball.off");
    std::vector<std::string> arguments{folder / "ball.off", "--screenshot", file, "--press"};
    for (const auto& key : keys_to(method))
        arguments.push_back(key);
    arguments.emplace_back("T");
    return view_without_display(arguments);
}

TEST(ViewerWithoutDisplay, SaysSo) {
    const auto outcome = view_without_display({"slab"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err,
                testing::AllOf(HasSubstr("there is no display"), HasSubstr("--screenshot FILE")));
}

TEST(ViewerWithoutDisplay, TakesAPictureAllTheSame) {
    const TemporaryFolder folder;
    const auto file = folder / "thickness.png";
    const auto outcome = take_picture(folder, "constant", file);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const auto picture = renderer::imaging::read_encoded(file);
    ASSERT_TRUE(picture) << picture.error();
    EXPECT_EQ(colours_in_the_middle(picture->image), 1U); // one thickness, one colour
    EXPECT_EQ(code(picture->image, 1270, 790, 0), 128);
    EXPECT_TRUE(renderer::imaging::read_exr(folder / "thickness.exr"));
}

TEST(ViewerWithoutDisplay, FailsWhenAPictureCannotBeWhatWasAskedFor) {
    const TemporaryFolder folder;
    const auto file = folder / "thickness.png";
    const auto outcome = take_picture(folder, "phong", file);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("Phong has no thickness"));
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(ViewerWithoutDisplay, RefusesKeysAndNamesThatMeanNothing) {
    EXPECT_THAT(view_without_display({"slab", "--press", "Q"}).err, HasSubstr("--press Q"));
    EXPECT_THAT(view_without_display({"slab", "--screenshot", "a.jpg"}).err, HasSubstr(".png"));
    EXPECT_THAT(view_without_display({"no-such-thing"}).err, HasSubstr("no-such-thing"));
}

} // namespace
