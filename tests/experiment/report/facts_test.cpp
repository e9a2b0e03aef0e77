#include "experiment/report/facts.h"
#include "tests/experiment/report/shared_experiment.h"

#include <algorithm>

namespace {

using namespace experiment::report;
using namespace experiment::store;
using std::chrono::milliseconds;
using testing::HasSubstr;

Records two_sittings() {
    Records records;
    auto& study = records.study;
    study.id = "pilot";
    study.title = "A pilot";
    study.question = "Which is more realistic?";
    study.seed = 42;
    study.width = 512;
    study.height = 384;
    study.conditions = {{{"SHSS"}, "SHSS, 25 coefficients", {}, 3}, {{"Green"}, "", {}, 4}};
    study.scenes = {{.id = {"Dragon"}, .label = "the dragon"}};
    study.variants = {{.id = {"back"}, .label = "from behind"}};
    records.study_sha256 = "feedbeef";

    experiment::stimuli::Manifest manifest;
    auto& picture = manifest.pictures[{{"Dragon"}, {"back"}, {"SHSS"}}];
    picture.renderer = "OpenGL: llvmpipe";
    picture.dials = {{"bands", "5"}};
    picture.brightness = {.mean_before = 0.1, .target = 0.2, .gain = 2, .clipped_share = 0};
    records.manifest = manifest;

    Sitting first;
    first.start = {.key = {{"O01"}, 1},
                   .local_date = "2026-11-20",
                   .started_utc = "2026-11-20T09:00:00.250Z",
                   .order_seed = "0a",
                   .sides_seed = "0b",
                   .scene_rule = "no two neighbours share a scene",
                   .timing_grade = "A"};
    first.finished_utc = "2026-11-20T09:12:05.250Z";
    first.votes = {{.trial = 8, .response_time = milliseconds(250), .early_keys = 2},
                   {.trial = 9, .response_time = milliseconds(1750)}};
    first.events = {{.kind = "break"}, {.kind = "break"}, {.kind = "resumed"}};
    Sitting second = first;
    second.start.key.session = 2;
    second.start.scene_rule = "one pair of neighbours shares a scene";
    second.start.simulation = "scores SHSS=1 Green=0";
    second.start.override_reason = "the observer leaves tomorrow";
    second.finished_utc.reset();
    records.sittings = {first, second};
    return records;
}

std::optional<std::string>
value_of(const ReportContents& contents, const std::string& heading, const std::string& name) {
    const auto list = std::ranges::find(contents.facts, heading, &FactList::heading);
    EXPECT_NE(list, contents.facts.end()) << heading;
    const auto fact = std::ranges::find(list->facts, name, &Fact::name);
    EXPECT_NE(fact, list->facts.end()) << name;
    return fact->value;
}

ReportContents contents_under_test() {
    return report_contents(two_sittings(), shared_experiment().findings, "2026-11-22");
}

TEST(ReportFacts, TellWhatIsOnRecord) {
    const auto contents = contents_under_test();
    EXPECT_EQ(contents.title, "A pilot");
    EXPECT_EQ(value_of(contents, "Study", "Study file, SHA-256"), "feedbeef");
    EXPECT_EQ(value_of(contents, "Stimuli", "Drawn by"), "OpenGL: llvmpipe");
    EXPECT_EQ(value_of(contents, "Stimuli", "Conditions"),
              "SHSS, 25 coefficients (bands 5)\nGreen");
    EXPECT_EQ(value_of(contents, "Design", "Seed of the study"), "42");
    EXPECT_EQ(value_of(contents, "Design", "Order"),
              "no two neighbours share a scene (1 session)\n"
              "one pair of neighbours shares a scene (1 session)");
    EXPECT_EQ(value_of(contents, "Sessions as held", "Begun, finished"), "2, 1");
    EXPECT_EQ(value_of(contents, "Sessions as held", "Events"), "break 4, resumed 2");
    EXPECT_EQ(value_of(contents, "Sessions as held", "Exceptions from that"),
              "O01, session 2: the observer leaves tomorrow");
    EXPECT_EQ(value_of(contents, "Votes", "Answers before input opened"), "4");
    EXPECT_EQ(value_of(contents, "Votes", "Response times"), "median 1000 ms; 2 of 4 under 300 ms");
    // The golden experiment's: exact p 0.0557, 142 triads against 270, zeta 0.7370, both shares
    // 0.647.
    EXPECT_THAT(value_of(contents, "Votes", "Left picture chosen").value_or(""),
                testing::AllOf(testing::StartsWith("849 of 1620 votes, exact binomial"),
                               testing::EndsWith("0.056")));
    EXPECT_EQ(value_of(contents, "Votes", "Circular triads"),
              "142 in 270 rounds, 270 expected by chance; mean zeta 0.737");
    EXPECT_EQ(value_of(contents, "Votes", "Repeatability between sessions of an observer"),
              "65\u00a0% identical answers, by chance 50\u00a0%");
    EXPECT_EQ(value_of(contents, "Votes", "Agreement between observers in the same session"),
              "65\u00a0% identical answers, by chance 50\u00a0%");
}

TEST(ReportFacts, TakeTheTimingGradeFromTheEndOfASitting) {
    auto records = two_sittings();
    records.sittings[0].events.push_back(
        {"timing", "grade=C; frames=200; late=4; refreshes_missed=5", 0, ""});
    records.sittings[0].events.push_back( // stopped, and taken up again
        {"timing", "grade=B; frames=100; late=0; refreshes_missed=0", 0, ""});
    records.sittings[1].events.push_back(
        {"timing", "grade=U; frames=200; late=0; refreshes_missed=0", 0, ""});
    auto contents = report_contents(records, shared_experiment().findings, "");
    EXPECT_EQ(contents.sittings[0].timing_grade, "C"); // A was promised
    EXPECT_EQ(contents.sittings[0].late_frames, "4 of 300");
    EXPECT_EQ(contents.sittings[1].timing_grade, "U");
    EXPECT_EQ(contents.sittings[1].late_frames, "");
    EXPECT_EQ(value_of(contents, "Sessions as held", "Timing grade"),
              "C (1 session)\nU (1 session)");
    EXPECT_EQ(value_of(contents, "Sessions as held", "Frames late"),
              "4 of 300, not verifiable in 1 session (grade U)");
    contents = contents_under_test(); // neither has come to its end
    EXPECT_EQ(contents.sittings[0].timing_grade, "A");
    EXPECT_EQ(value_of(contents, "Sessions as held", "Frames late"), std::nullopt);
}

TEST(ReportFacts, TellOfTheRoomAndTheDisplayWhatIsRecorded) {
    auto records = two_sittings();
    records.study.room.peak_cd_m2 = 120;
    records.study.room.ambient_lux = 15;
    records.study.display.distance_mm = 700;
    records.sittings[0].start.display = "screen=full; pixels_per_degree=44.1";
    records.sittings[1].start.display = "screen=full; pixels_per_degree=38.5";
    records.sittings[0].events.push_back({"room", "peak_cd_m2=118", 0, ""});
    const auto contents = report_contents(records, shared_experiment().findings, "");
    const auto* heading = "Display and room";
    EXPECT_EQ(value_of(contents, heading, "Peak and black luminance"), "white 120 cd/m\u00b2");
    EXPECT_EQ(value_of(contents, heading, "Room illuminance"), "15 lux");
    EXPECT_EQ(value_of(contents, heading, "Room, as recorded with the sessions"), "peak_cd_m2=118");
    EXPECT_EQ(value_of(contents, heading, "Viewing distance"),
              "700 mm, pixels per degree: 38.5 (1 session)\n44.1 (1 session)");
    EXPECT_EQ(value_of(contents, heading, "Background ratio and chromaticity"), std::nullopt);
}

TEST(ReportFacts, TellOfTheObserversWhatTheyAnsweredLast) {
    auto records = two_sittings();
    records.answers[{"O01"}] = {{"age", "20-24", ""},
                                {"age", "25-29", ""},
                                {"acuity", "1", ""},
                                {"screening", "passed", ""},
                                {"place", "0", ""}};
    records.answers[{"O02"}] = {{"age", "25-29", ""}, {"screening", "failed: acuity", ""}};
    records.screened = {{"O01"}};
    const auto contents = report_contents(records, shared_experiment().findings, "");
    EXPECT_EQ(contents.screened, 1u);
    EXPECT_EQ(value_of(contents, "Observers", "Ages, sex"), "age 25-29: 2");
    EXPECT_EQ(value_of(contents, "Observers", "Vision tests"), "decimal acuity 1: 1");
    EXPECT_EQ(value_of(contents, "Observers", "Screened, excluded"),
              "1 passed and finished a sitting (failed: acuity: 1; passed: 1); nobody is left out "
              "of the analyses");
}

TEST(ReportFacts, LeaveOpenWhatIsNot) {
    const auto contents = contents_under_test();
    EXPECT_EQ(value_of(contents, "Observers", "Vision tests"), std::nullopt);
    EXPECT_EQ(value_of(contents, "Display and room", "Room illuminance"), std::nullopt);
    EXPECT_EQ(value_of(contents, "Study", "Instructions"), std::nullopt);
    const auto empty = report_contents({}, shared_experiment().findings, "");
    EXPECT_EQ(value_of(empty, "Design", "Order"), std::nullopt);
    EXPECT_EQ(value_of(empty, "Votes", "Response times"), std::nullopt);
    EXPECT_EQ(value_of(empty, "Stimuli", "Drawn by"), std::nullopt);
}

TEST(ReportFacts, NameTheDeviations) {
    const auto text = value_of(contents_under_test(),
                               "Deviations from ITU-R BT.500, data and licence", "Deviations");
    ASSERT_TRUE(text.has_value());
    EXPECT_THAT(*text, HasSubstr("10 observers, fewer than 15: informal"));
    EXPECT_THAT(*text, HasSubstr("sessions nearer to each other than planned"));
}

TEST(ReportFacts, ListSittingsAndBrightness) {
    const auto contents = contents_under_test();
    ASSERT_EQ(contents.sittings.size(), 2U);
    EXPECT_EQ(contents.sittings[0].duration, "12 min 5 s");
    EXPECT_EQ(contents.sittings[0].order_seed, "0a");
    EXPECT_EQ(contents.sittings[0].sides_seed, "0b");
    EXPECT_FALSE(contents.sittings[0].simulated);
    EXPECT_EQ(contents.sittings[1].duration, "");
    EXPECT_TRUE(contents.sittings[1].simulated);
    EXPECT_EQ(value_of(contents, "Sessions as held", "Simulated observers"),
              "scores SHSS=1 Green=0");
    ASSERT_EQ(contents.brightness.size(), 1U);
    EXPECT_EQ(contents.brightness[0].gain, 2);
    EXPECT_EQ(contents.labels.scenes.at("Dragon"), "the dragon");
    EXPECT_EQ(condition_label(contents, 0), "SHSS, 25 coefficients");
}

} // namespace
