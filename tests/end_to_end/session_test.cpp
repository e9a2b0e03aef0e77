// The real window under a virtual screen: a whole sitting by injected keys, and one killed in the
// middle.
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"
#include "tests/end_to_end/virtual_screen.h"

#include <fmt/core.h>

#include <chrono>
#include <optional>
#include <set>
#include <sstream>
#include <thread>

namespace {

using namespace tests;
using renderer::imaging::EncodedImage;
using Clock = std::chrono::steady_clock;

constexpr int screen_width = 800;
constexpr int screen_height = 600;
constexpr int gap = 20;
constexpr int left_edge = (screen_width - 2 * picture_width - gap) / 2;
constexpr int top_edge = (screen_height - picture_height) / 2;

const std::vector<std::string> scenes{"garden", "harbour"};
const std::vector<std::string> conditions{"first", "second", "third"};

struct VoteLine {
    std::string scene, left, right, chosen;
};

std::vector<VoteLine> votes(const std::filesystem::path& study) {
    const auto exported = pairlight({"export", study.string(), "--format", "long"});
    std::vector<VoteLine> lines;
    std::istringstream text(exported.out);
    std::string line;
    std::getline(text, line);
    while (std::getline(text, line)) {
        std::vector<std::string> fields;
        std::istringstream row(line);
        for (std::string field; std::getline(row, field, ',');)
            fields.push_back(field);
        lines.push_back({fields.at(4), fields.at(6), fields.at(7), fields.at(8)});
    }
    return lines;
}

RunningProgram sitting(const TemporaryFolder& study) {
    return RunningProgram({PAIRLIGHT_PROGRAM, "session", study.path().string(), "--observer", "P1"},
                          study / "stderr");
}

EncodedImage cut(const EncodedImage& screen, int left, int top) {
    EncodedImage piece{picture_width, picture_height, 8, {}};
    for (int y = top; y < top + picture_height; ++y) {
        const auto row = screen.codes.begin() + 3 * (y * screen.width + left);
        piece.codes.insert(piece.codes.end(), row, row + 3 * picture_width);
    }
    return piece;
}

/// The pair on the screen, if one is there in full.
std::optional<VoteLine> pair_shown(const EncodedImage& screen) {
    const auto left = cut(screen, left_edge, top_edge).codes;
    const auto right = cut(screen, left_edge + picture_width + gap, top_edge).codes;
    for (const auto& scene : scenes)
        for (const auto& a : conditions)
            for (const auto& b : conditions)
                if (left == small_picture(scene, a).codes && right == small_picture(scene, b).codes)
                    return VoteLine{scene, a, b, ""};
    return std::nullopt;
}

bool is_in_a_picture(int x, int y) {
    const bool in_left = x >= left_edge && x < left_edge + picture_width;
    const bool in_right = x >= left_edge + picture_width + gap && x < screen_width - left_edge;
    return y >= top_edge && y < top_edge + picture_height && (in_left || in_right);
}

/// Pixels outside the pictures that are not code 128 in every channel.
int pixels_off_grey(const EncodedImage& screen) {
    int off = 0;
    for (int y = 0; y < screen.height; ++y)
        for (int x = 0; x < screen.width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                off +=
                    !is_in_a_picture(x, y) &&
                    screen.codes[static_cast<std::size_t>(3 * (y * screen.width + x) + channel)] !=
                        128;
    return off;
}

/// Presses every key a sitting waits for, again and again, until `done` says so.
template <class Done>
bool press_on(const VirtualScreen& screen,
              RunningProgram& program,
              const std::string& answer,
              Done done) {
    const auto deadline = Clock::now() + std::chrono::seconds(120);
    while (program.is_running() && Clock::now() < deadline) {
        for (const auto& key : {std::string("space"), std::string("F9"), answer})
            screen.press(key);
        if (done())
            return true;
    }
    return !program.is_running();
}

class SessionWindow : public testing::Test {
  protected:
    VirtualScreen screen{screen_width, screen_height};
    TemporaryFolder study;

    void SetUp() override { write_small_study(study.path()); }
};

TEST_F(SessionWindow, ShowsBothPicturesOnGreyAndKeepsEveryVote) {
    auto program = sitting(study);
    std::set<std::string> seen;
    // A pair stays until it is answered, and only what is on the photograph is: however slow or
    // fast the machine, no sitting ends without one.
    const auto answer_what_is_seen = [&] {
        const auto photograph = screen.photograph();
        if (const auto pair = pair_shown(photograph)) {
            seen.insert(pair->scene + ",," + pair->left + "," + pair->right);
            EXPECT_EQ(pixels_off_grey(photograph), 0);
            screen.press("Left");
        }
        return false;
    };
    ASSERT_TRUE(press_on(screen, program, "space", answer_what_is_seen))
        << "the sitting did not end";
    EXPECT_EQ(program.status(), 0) << read_file(study / "stderr");
    // Left on the screen is left in the plan: a photographed pair that the plan has only mirrored
    // would not be found there.
    EXPECT_GE(seen.size(), 1u) << "no photograph caught a pair";
    const auto plan =
        pairlight({"schedule", study.path().string(), "--observer", "P1", "--quiet"}).out;
    for (const auto& pair : seen)
        EXPECT_THAT(plan, testing::HasSubstr("," + pair + "\n"));

    const auto kept = votes(study.path());
    EXPECT_EQ(kept.size(), static_cast<std::size_t>(pairs_asked));
    for (const auto& vote : kept) {
        EXPECT_EQ(vote.chosen, "left");
        EXPECT_THAT(plan,
                    testing::HasSubstr("main," + vote.scene + ",," + vote.left + "," + vote.right));
    }
    EXPECT_EQ(pairlight({"verify", study.path().string()}).status, 0);
}

TEST_F(SessionWindow, TakesAClickOnAPictureForAnAnswer) {
    auto program = sitting(study);
    const int right_middle = left_edge + picture_width + gap + picture_width / 2;
    const auto click = [&] {
        screen.click(right_middle, screen_height / 2);
        return false;
    };
    ASSERT_TRUE(press_on(screen, program, "space", click)) << "the sitting did not end";
    const auto kept = votes(study.path());
    ASSERT_EQ(kept.size(), static_cast<std::size_t>(pairs_asked));
    for (const auto& vote : kept)
        EXPECT_EQ(vote.chosen, "right");
}

TEST_F(SessionWindow, LosesNoVoteWhenKilledAndGoesOnAfterwards) {
    auto killed = sitting(study);
    ASSERT_TRUE(press_on(screen, killed, "Left", [&] { return votes(study.path()).size() >= 2; }));
    ASSERT_TRUE(killed.is_running()) << "the sitting was over before it could be killed";
    killed.kill_at_once();
    const auto before = votes(study.path());
    ASSERT_GE(before.size(), 2u);

    auto resumed = sitting(study);
    ASSERT_TRUE(press_on(screen, resumed, "Right", [] { return false; }));
    EXPECT_EQ(resumed.status(), 0) << read_file(study / "stderr");
    const auto after = votes(study.path());
    ASSERT_EQ(after.size(), static_cast<std::size_t>(pairs_asked));
    std::set<std::set<std::string>> asked;
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_EQ(after[i].chosen, i < before.size() ? "left" : "right") << "vote " << i;
        asked.insert({after[i].scene, after[i].left, after[i].right});
    }
    EXPECT_EQ(asked.size(), static_cast<std::size_t>(pairs_asked)) << "a pair was asked twice";
    EXPECT_EQ(pairlight({"verify", study.path().string()}).status, 0);
}

TEST_F(SessionWindow, RefusesAnObserverWhoHasFinished) {
    ASSERT_EQ(
        pairlight({"session", study.path().string(), "--observer", "P1", "--simulate", ""}).status,
        0);
    const auto store = read_file(study / "votes.sqlite");
    const auto again = pairlight({"session", study.path().string(), "--observer", "P1"});
    EXPECT_NE(again.status, 0);
    EXPECT_THAT(again.err, testing::HasSubstr("observer P1 has finished"));
    EXPECT_TRUE(read_file(study / "votes.sqlite") == store) << "the store was changed";
}

TEST_F(SessionWindow, RefusesPicturesThatDoNotFitTheScreen) {
    const auto small =
        pairlight({"session", study.path().string(), "--observer", "P1", "--window", "300x200"});
    EXPECT_NE(small.status, 0);
    EXPECT_THAT(small.err, testing::HasSubstr("300"));
    EXPECT_FALSE(std::filesystem::exists(study / "votes.sqlite"));
}

} // namespace
