#include "experiment/viewer/viewer_state.h"
#include "renderer/methods/catalogue.h"
#include "tests/experiment/viewer/small_exhibit.h"

#include <glm/gtc/quaternion.hpp>

namespace {

using namespace experiment::viewer;
using renderer::methods::DialValue;
using testing::HasSubstr;

class ViewerStateTest : public testing::Test {
  protected:
    void press(const Input& input) { state = reduce(state, input, exhibit); }

    const Side& active() const { return state.sides[state.active]; }

    Exhibit exhibit = tests::exhibit_of_body("sphere");
    ViewerState state = initial_state(exhibit);
};

TEST_F(ViewerStateTest, BeginsWithTheFirstTwoChoicesAndTheLeftOneAlone) {
    EXPECT_EQ(state.sides[0].method, exhibit.choices[0].method);
    EXPECT_EQ(state.sides[1].method, exhibit.choices[1].method);
    EXPECT_TRUE(is_seen(state, 0));
    EXPECT_FALSE(is_seen(state, 1));
}

TEST_F(ViewerStateTest, WalksOnlyUpToThePoles) {
    exhibit.pieces[0].scene.elevation_degrees = 20;
    press(WalkEye{30, 50});
    EXPECT_DOUBLE_EQ(state.orbit.right_degrees, 30);
    EXPECT_DOUBLE_EQ(state.orbit.up_degrees, 50);
    press(WalkEye{0, 50});
    EXPECT_DOUBLE_EQ(state.orbit.up_degrees, 70); // 90 above the horizon
    press(WalkEye{0, -500});
    EXPECT_DOUBLE_EQ(state.orbit.up_degrees, -110);
}

TEST_F(ViewerStateTest, GoesRoundInWholeTurns) {
    for (int i = 0; i < 72; ++i)
        press(WalkEye{5, 0});
    EXPECT_NEAR(state.orbit.right_degrees, 0, 1e-9); // 72 roundings of numbers below 360
}

TEST_F(ViewerStateTest, TurnsTheLightAsTheEyeSeesIt) {
    press(TurnLight{90, 0});
    const auto front = state.light_turn * glm::dvec3(0, 0, 1);
    EXPECT_NEAR(front.x, 1, 1e-12); // from the viewer to the right
    state = initial_state(exhibit);
    press(TurnLight{0, 90});
    EXPECT_NEAR((state.light_turn * glm::dvec3(0, 0, 1)).y, 1, 1e-12); // to above
    state = initial_state(exhibit);
    press(WalkEye{90, 0}); // the eye now stands at +x, and its right is -z
    press(TurnLight{90, 0});
    EXPECT_NEAR((state.light_turn * glm::dvec3(1, 0, 0)).z, -1, 1e-12);
}

TEST_F(ViewerStateTest, ZoomsWithinLimits) {
    for (int i = 0; i < 200; ++i)
        press(Zoom{1.1});
    EXPECT_EQ(state.orbit.zoom, most_zoom);
    for (int i = 0; i < 200; ++i)
        press(Zoom{1 / 1.1});
    EXPECT_EQ(state.orbit.zoom, least_zoom);
}

TEST_F(ViewerStateTest, ChangesTheActiveSideOnly) {
    press(tests::choice_of(exhibit, "phong"));
    EXPECT_EQ(state.sides[0].method, "phong");
    EXPECT_EQ(state.sides[1].method, exhibit.choices[1].method);
    press(Command::OtherSide);
    EXPECT_TRUE(is_seen(state, 1));
    EXPECT_FALSE(is_seen(state, 0));
    press(tests::choice_of(exhibit, "constant"));
    EXPECT_EQ(state.sides[0].method, "phong");
    EXPECT_EQ(state.sides[1].method, "constant");
}

TEST_F(ViewerStateTest, RefusesAMethodThereIsNot) {
    const auto before = state.sides;
    press(Choose{exhibit.choices.size()});
    EXPECT_EQ(state.sides, before);
    EXPECT_THAT(state.refusal, HasSubstr("there is no method"));
    press(Zoom{1.1});
    EXPECT_EQ(state.refusal, "");
}

TEST_F(ViewerStateTest, GoesThroughAllChoicesAndRound) {
    const auto begin = active();
    for (std::size_t i = 0; i < exhibit.choices.size(); ++i)
        press(ChooseNext{1});
    EXPECT_EQ(active(), begin);
    press(ChooseNext{-1});
    EXPECT_EQ(active().method, exhibit.choices.back().method);
}

TEST_F(ViewerStateTest, EveryDialOfEveryMethodTurnsBothWays) {
    for (std::size_t i = 0; i < exhibit.choices.size(); ++i) {
        press(Choose{i});
        const auto& dials = renderer::methods::find_method(active().method)->dials;
        for (const auto& dial : dials)
            for (const int by : {1, -1}) {
                press(TurnDial{dial.name, by});
                EXPECT_TRUE(renderer::methods::complete_for(active().method, active().dials))
                    << active().method << " " << dial.name;
            }
    }
}

TEST_F(ViewerStateTest, PicksDialsAndTurnsThePickedOne) {
    press(tests::choice_of(exhibit, "constant"));
    const auto& dials = renderer::methods::find_method("constant")->dials;
    ASSERT_EQ(dials.size(), 2U);
    press(PickDial{1});
    EXPECT_EQ(dials[state.dial].name, "thickness_mm");
    press(TurnDial{"", 1});
    EXPECT_EQ(active().dials.at("thickness_mm"), DialValue(12.5));
    press(PickDial{1});
    EXPECT_EQ(state.dial, 0U);
}

TEST_F(ViewerStateTest, SaysWhatAMethodHasNot) {
    press(tests::choice_of(exhibit, "phong"));
    press(TurnDial{"law", 1});
    EXPECT_EQ(state.refusal, "Phong has no dial law");
    press(PickDial{1});
    EXPECT_EQ(state.refusal, "Phong has no dials");
    press(TurnDial{"", 1});
    EXPECT_EQ(state.refusal, "Phong has no dials");
}

TEST_F(ViewerStateTest, RefusesDialsThatDoNotGoTogetherInWords) {
    press(tests::choice_of(exhibit, "shss"));
    const auto before = active();
    press(SetDial{state.active, "directions", std::int64_t{3}});
    EXPECT_EQ(active(), before);
    EXPECT_THAT(state.refusal, HasSubstr("'directions' is 3, expected"));
}

TEST_F(ViewerStateTest, ALookIsLeftByTheKeyThatBroughtIt) {
    press(LookAt{Look::Thickness});
    EXPECT_EQ(state.look, Look::Thickness);
    press(LookAt{Look::Error});
    EXPECT_EQ(state.look, Look::Error);
    EXPECT_TRUE(is_seen(state, 0) && is_seen(state, 1)); // a difference takes both
    press(LookAt{Look::Error});
    EXPECT_EQ(state.look, Look::Light);
}

TEST_F(ViewerStateTest, TheLineStaysOnThePicture) {
    for (int i = 0; i < 60; ++i)
        press(MoveSplit{0.02});
    EXPECT_EQ(state.split_at, 1);
    for (int i = 0; i < 60; ++i)
        press(MoveSplit{-0.02});
    EXPECT_EQ(state.split_at, 0);
}

TEST_F(ViewerStateTest, AnotherVariantOrHomePutsTheLightBack) {
    for (const Input& input : {Input{NextVariant{1}}, Input{Command::Home}}) {
        press(TurnLight{40, 10});
        press(input);
        EXPECT_EQ(state.light_turn, glm::dquat(1, 0, 0, 0));
    }
    EXPECT_EQ(state.variant, 1U);
    press(NextVariant{-2});
    EXPECT_EQ(state.variant, exhibit.variants.size() - 1);
}

TEST_F(ViewerStateTest, TitlesNameTheChoiceOrTheDialsThatWereTurned) {
    press(tests::choice_of(exhibit, "shss"));
    EXPECT_EQ(title(active(), exhibit), "SHSS");
    press(TurnDial{"law", 1});
    EXPECT_EQ(title(active(), exhibit), "SHSS, law paper");
}

TEST_F(ViewerStateTest, CountsThePicturesAskedForAndEndsWhenTold) {
    press(Command::TakePicture);
    press(Command::TakePicture);
    EXPECT_EQ(state.pictures, 2);
    EXPECT_FALSE(state.done);
    press(Command::Quit);
    EXPECT_TRUE(state.done);
}

} // namespace
