#include "experiment/cost/earlier_runs.h"
#include "tests/experiment/cost/small_report.h"

namespace {

using namespace experiment::cost;
using testing::HasSubstr;

EarlierRun ball() {
    return {"a/cost.json", tests::small_report()};
}

/// The same of another scene.
EarlierRun cube() {
    auto run = ball();
    run.file = "b/cost.json";
    run.report.subject = "A cube";
    run.report.scenes[0].id = "cube";
    return run;
}

TEST(EarlierRuns, StandTogetherUnderAllTheirNames) {
    const auto whole = together({ball(), cube(), {"c.json", {}}});
    ASSERT_FALSE(whole); // the third was made by nobody
    const auto both = together({ball(), cube()});
    ASSERT_TRUE(both) << both.error();
    EXPECT_EQ(both->subject, "A ball, A cube");
    EXPECT_EQ(both->scenes.size(), 2U);
    EXPECT_EQ(both->scenes[1], cube().report.scenes[0]);
}

TEST(EarlierRuns, AreKeptUnderTheNameOfWhatTheyMeasured) {
    EXPECT_TRUE(expect_subject({ball(), cube()}, "A cube", "my-study"));
    auto both = ball();
    both.report.subject = "A ball, A cube";
    EXPECT_TRUE(expect_subject({both}, "A ball", "my-study"));
    EXPECT_TRUE(expect_subject({both}, "A cube", "my-study"));
    EXPECT_TRUE(expect_subject({both}, "A ball, A cube", "my-study"));
    EXPECT_EQ(expect_subject({ball(), cube()}, "ball", "ball.ply").error(),
              "a/cost.json: measured is \"A ball\", \"A cube\", and ball.ply is \"ball\"; expected "
              "the name of what was measured");
    EXPECT_FALSE(expect_subject({both}, "A", "a.off"));
}

TEST(EarlierRuns, HaveEveryPictureOnce) {
    EXPECT_EQ(together({ball(), ball()}).error(),
              "a/cost.json: scene \"ball\", variant \"back\" is in an earlier --from already, "
              "expected it once");
    auto other_light = ball();
    other_light.report.scenes[0].lights = {
        {.id = "top", .label = "", .reference = "", .choice = {}}};
    EXPECT_TRUE(together({ball(), other_light}));
}

TEST(EarlierRuns, AreOfOneProgramOneRendererAndOneWayToMeasure) {
    const auto complaint = [](auto change) {
        auto other = cube();
        change(other.report);
        const auto whole = together({ball(), other});
        return whole ? "" : whole.error();
    };
    EXPECT_EQ(complaint([](CostReport& r) { r.renderer = "a graphics card"; }),
              "b/cost.json: drawn by a graphics card; expected nothing as in a/cost.json");
    EXPECT_THAT(complaint([](CostReport& r) { r.program = "pairlight 9"; }),
                HasSubstr("measured by pairlight 9; expected pairlight 0"));
    EXPECT_THAT(complaint([](CostReport& r) { r.law = "paper"; }), HasSubstr("law paper"));
    EXPECT_THAT(complaint([](CostReport& r) { r.timed_by = "clock"; }),
                HasSubstr("timed by clock"));
    EXPECT_THAT(complaint([](CostReport& r) { r.rounds = 7; }), HasSubstr("rounds 7; expected 3"));
    EXPECT_THAT(complaint([](CostReport& r) { r.held_out_lights = 1; }),
                HasSubstr("held-out lights 1"));
    EXPECT_EQ(complaint([](CostReport& r) { r.written_on = "tomorrow"; }), "");
}

TEST(EarlierRuns, KeepWhatWasMeasuredOfAChoiceThatStays) {
    auto report = tests::small_report();
    choose_again(report, {.error = ErrorKind::Law, .tolerance = 0.05});
    report.scenes[0].lights[0].choice->measured = 0.041;
    choose_again(report, {.error = ErrorKind::Law, .tolerance = 0.06});
    EXPECT_EQ(report.scenes[0].lights[0].choice->measured, 0.041);
    EXPECT_EQ(report.wish.tolerance, 0.06);
    choose_again(report, {.error = ErrorKind::Law, .tolerance = 0.02});
    EXPECT_EQ(report.scenes[0].lights[0].choice->row, 1U);
    EXPECT_FALSE(report.scenes[0].lights[0].choice->measured);
}

} // namespace
