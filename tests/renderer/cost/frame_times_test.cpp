// Who draws when, and what is measured: never how fast.
#include "renderer/cost/frame_times.h"
#include "renderer/gpu/context.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <thread>

namespace {

using namespace renderer;
using namespace renderer::cost;
using testing::Each;
using testing::Ge;
using testing::SizeIs;

/// Keeps a diary.
class Diarist : public methods::Method {
  public:
    Diarist(char name, std::string& diary, std::chrono::milliseconds takes = {})
        : name_(name), diary_(diary), takes_(takes) {}

    Expected<void> update(const Scene& scene, double) override {
        directions.push_back(std::get<DirectionalLight>(scene.lights.front().place).to_light);
        return {};
    }

    void draw(const Scene&) override {
        std::this_thread::sleep_for(takes_);
        diary_ += name_;
    }

    methods::Cost cost() const override { return {}; }

    std::vector<glm::dvec3> directions;

  private:
    char name_;
    std::string& diary_;
    std::chrono::milliseconds takes_;
};

class FrameTimes : public testing::Test {
  protected:
    static void SetUpTestSuite() { context_.emplace(*gpu::Context::surfaceless()); }

    static void TearDownTestSuite() { context_.reset(); }

    std::vector<cost::FrameTimes> times(std::span<const Turn> turns, const TurnOptions& options) {
        const auto target = gpu::Target::create(8, 8);
        auto result = take_turns(turns, {}, *target, options);
        EXPECT_TRUE(result);
        return *result;
    }

    std::string diary_;

  private:
    inline static std::optional<gpu::Context> context_;
};

// Before each turn's frames one that does not count; the round before the first draws one of each.
TEST_F(FrameTimes, AreTakenInTurnsThatBeginWithTheNext) {
    Diarist a('a', diary_), b('b', diary_);
    const std::vector<Turn> turns{{&a, true}, {&b, true}};
    const auto measured = times(turns, {.rounds = 2, .frames = 2});
    EXPECT_EQ(diary_, "aabb"
                      "bbbaaa"
                      "aaabbb");
    ASSERT_THAT(measured, SizeIs(2));
    for (const auto& one : measured) {
        EXPECT_THAT(one.clock, SizeIs(2));
        EXPECT_THAT(one.processor, SizeIs(2));
        EXPECT_THAT(one.clock, Each(Ge(0)));
    }
}

TEST_F(FrameTimes, MoveTheLightOrLetItRest) {
    Diarist a('a', diary_), b('b', diary_);
    times(std::vector<Turn>{{&a, true}, {&b, false}}, {.rounds = 1, .frames = 3});
    ASSERT_THAT(a.directions, SizeIs(6));
    for (std::size_t i = 1; i < 6; ++i)
        EXPECT_NE(a.directions[i], a.directions[i - 1]) << i;
    EXPECT_THAT(b.directions, Each(b.directions.front()));
}

TEST_F(FrameTimes, AskTheSlowForFewerFrames) {
    Diarist slow('s', diary_, std::chrono::milliseconds(20)), quick('q', diary_);
    const auto measured = times(std::vector<Turn>{{&slow, true}, {&quick, true}},
                                {.rounds = 5, .frames = 2, .slow = 0.01, .slow_rounds = 2});
    EXPECT_THAT(measured[0].clock, SizeIs(2));
    EXPECT_THAT(measured[0].clock, Each(Ge(0.02))); // it slept that long in each
    EXPECT_THAT(measured[1].clock, SizeIs(5));
    EXPECT_EQ(std::ranges::count(diary_, 's'), 2 + 2 * 2);
}

} // namespace
