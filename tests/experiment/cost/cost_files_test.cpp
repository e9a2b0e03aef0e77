#include "analysis/csv.h"
#include "experiment/cost/choices.h"
#include "experiment/cost/cost_figures.h"
#include "experiment/cost/cost_files.h"
#include "experiment/cost/cost_page.h"
#include "tests/experiment/cost/small_report.h"

#include <algorithm>

namespace {

using namespace experiment::cost;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

CostReport with_choice() {
    auto report = tests::small_report();
    report.scenes[0].lights[0].choice = choose(report.scenes[0], 0, report.wish);
    report.scenes[0].lights[0].choice->measured = 0.041;
    return report;
}

TEST(CostJson, IsReadBackAsItWasWritten) {
    const auto report = with_choice();
    const auto again = parse_cost(cost_json(report), "cost.json");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(*again, report);
}

TEST(CostJson, SaysWhatIsWrongWithAFile) {
    EXPECT_THAT(parse_cost("{", "c.json").error(), StartsWith("c.json: not a cost report"));
    EXPECT_THAT(parse_cost("{\"form\": 1}", "c.json").error(), HasSubstr("run `pairlight cost`"));
    auto text = cost_json(with_choice());
    const std::string row = "\"row\": 2";
    ASSERT_NE(text.find(row), text.npos);
    text.replace(text.find(row), row.size(), "\"row\": 9");
    EXPECT_EQ(parse_cost(text, "c.json").error(), "c.json: a choice names a row that is not there");
}

TEST(CostJson, RefusesNumbersThatNothingMeasures) {
    const auto text = cost_json(with_choice());
    const auto complaint = [&](const std::string& there, const std::string& instead) {
        auto damaged = text;
        const auto place = damaged.find(there);
        EXPECT_NE(place, std::string::npos) << there;
        damaged.replace(place, there.size(), instead);
        const auto report = parse_cost(damaged, "c.json");
        return report ? "" : report.error();
    };
    EXPECT_EQ(
        complaint("\"bytes_per_vertex\": 100", "\"bytes_per_vertex\": -5"),
        "c.json: bytes_per_vertex is -5, expected a whole number from 0; run `pairlight cost` "
        "again");
    EXPECT_THAT(complaint("\"bytes_per_vertex\": 100", "\"bytes_per_vertex\": 1.7"),
                HasSubstr("bytes_per_vertex is 1.7"));
    EXPECT_THAT(complaint("\"law\": 0.2", "\"law\": -0.5"), HasSubstr("law is -0.5"));
    EXPECT_THAT(complaint("\"law\": 0.2", "\"law\": 1e308"), HasSubstr("law is 1e+308"));
    EXPECT_THAT(complaint("\"lower\": 5", "\"lower\": 9995"), HasSubstr("lower <= median"));
    EXPECT_THAT(complaint("\"error\": \"law\"", "\"error\": \"bogus\""),
                HasSubstr("wish.error is \"bogus\""));
}

TEST(CostCsv, HasARowForEveryLightAndSettingAndNothingForWhatIsNotKnown) {
    const auto text = cost_csv(with_choice());
    EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 2 * 4);
    EXPECT_THAT(text, StartsWith("scene,variant,method,setting,precompute_s,bytes_per_vertex,"));
    EXPECT_THAT(
        text,
        HasSubstr(
            "ball,back,fine,bands 2,1.5,16,64,642,1280,30768,6,6,6,6,1.2,1.2,1.2,12,0.02,0.04,"
            ",,,,0.02,1,1,0,0,law,,,"));
    EXPECT_THAT(
        text,
        HasSubstr("ball,back,other,,,0,64,642,1280,30768,5.5,5.5,5.5,5.5,1.1,1.1,1.1,11,,,0.3,0.25,"
                  "0.6,0.1,0.02,0,0,1,1,,,,"));
}

TEST(CostFigures, NumberTheFrontAndRingTheChoice) {
    const auto report = with_choice();
    const auto figures = draw_cost_figures(report);
    ASSERT_TRUE(figures) << figures.error();
    ASSERT_EQ(figures->size(), 2U);
    const auto& figure = figures->front();
    EXPECT_EQ(figure.name, "cost-ball-back");
    EXPECT_THAT(figure.pdf, StartsWith("%PDF"));
    for (const auto* words :
         {"coarse", "fine", "other", "chosen", "thickness", "same law", "fitted k"})
        EXPECT_THAT(figure.svg, HasSubstr(words));
    EXPECT_THAT(figure.caption, HasSubstr("Ringed: fine, bands 2"));
    EXPECT_THAT((*figures)[1].svg, Not(HasSubstr("chosen")));
    EXPECT_THAT(front_of(report.scenes[0], 0, ErrorKind::Law), testing::ElementsAre(0U, 2U, 1U));
}

TEST(CostPage, AnswersWhichIsTheCheapestAndWhatWasLeftOut) {
    const auto report = with_choice();
    experiment::report::ReportContents contents;
    experiment::report::Body body(contents);
    add_cost(body, report, {});
    for (const auto& text : {body.markup(), cost_text(report)}) {
        EXPECT_THAT(text, HasSubstr("fine, bands 2"));
        EXPECT_THAT(text, HasSubstr("Left out: fine: error 1 % instead of 4 %"));
        EXPECT_THAT(text, HasSubstr("fine, bands 2 (6 ms, 16 B)"));
        EXPECT_THAT(text, HasSubstr("measured at the study\u2019s size: 4.1 %, within 20 %"));
        EXPECT_THAT(text, HasSubstr("reckoned 0.003, measured 0.0029"));
        EXPECT_THAT(text, HasSubstr("other: said something"));
    }
}

} // namespace
