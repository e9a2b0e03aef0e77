#include "experiment/report/figures.h"
#include "tests/experiment/report/shared_experiment.h"

namespace {

using namespace experiment::report;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Figures, AreDrawnAsSvgWithTextAndAsPdf) {
    const auto figures = draw_figures(shared_experiment());
    ASSERT_TRUE(figures.has_value()) << figures.error();
    ASSERT_EQ(figures->size(), 4U); // mean-votes, vote-matrix, scale, residuals
    for (const auto& figure : *figures) {
        EXPECT_THAT(figure.pdf, StartsWith("%PDF"));
        EXPECT_FALSE(figure.description.empty());
        if (figure.name == "residuals")
            continue; // points without names
        for (const auto* label : {"SHSS", "PRT", "Patro", "Green"}) {
            EXPECT_THAT(figure.svg, HasSubstr(label)) << figure.name;
            EXPECT_THAT(figure.description, HasSubstr(label)) << figure.name;
        }
    }
}

// Mean of 2.16667 +- t(0.975, 9) 0.0839597, t = 2.262157: 1.9767 to 2.3566.
TEST(Figures, ShowMeansIntervalsAndCounts) {
    const auto figures = draw_figures(shared_experiment());
    ASSERT_TRUE(figures.has_value()) << figures.error();
    EXPECT_THAT((*figures)[0].svg, HasSubstr("2.17  [1.98, 2.36]  a"));
    EXPECT_THAT((*figures)[0].svg, HasSubstr("95\u00a0% t intervals over 10 observers"));
    EXPECT_THAT((*figures)[0].caption, HasSubstr("95\u00a0% t intervals over 10 observers"));
    EXPECT_THAT(
        (*figures)[0].caption,
        HasSubstr("share a letter are not told apart by Tukey's test at the 5\u00a0% level"));
    const auto contents = shared_experiment();
    const auto& all = contents.findings.matrices.front();
    ASSERT_EQ(all.scope, "all");
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            if (i != j) {
                EXPECT_THAT((*figures)[1].svg,
                            HasSubstr(">" + std::to_string(all.matrix.wins(i, j)) + "<"));
            }
}

TEST(Figures, SayInTheirTitlesThatVotesAreSimulated) {
    auto votes = shared_votes();
    votes.simulated = true;
    const auto marked = draw_figures(contents_of(votes));
    ASSERT_TRUE(marked.has_value()) << marked.error();
    const auto plain = draw_figures(shared_experiment());
    ASSERT_TRUE(plain.has_value()) << plain.error();
    for (const auto& figure : *marked)
        EXPECT_THAT(figure.svg, HasSubstr("SIMULATED VOTES")) << figure.name;
    for (const auto& figure : *plain)
        EXPECT_THAT(figure.svg, Not(HasSubstr("SIMULATED"))) << figure.name;
    EXPECT_THAT(mean_votes_script(contents_of(votes), FigureForm::Pdf),
                HasSubstr("SIMULATED VOTES"));
}

TEST(Figures, KeepStrangersLabelsAsText) {
    auto contents = shared_experiment();
    contents.labels.conditions["SHSS"] = "<script>\"&' `date`</script>";
    const auto figures = draw_figures(contents);
    ASSERT_TRUE(figures.has_value()) << figures.error();
    EXPECT_THAT((*figures)[0].svg, Not(HasSubstr("<script>\"")));
    EXPECT_THAT((*figures)[0].svg, HasSubstr("`date`"));
}

} // namespace
