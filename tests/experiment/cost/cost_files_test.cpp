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
