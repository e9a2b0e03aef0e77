#include "analysis/vote_csv.h"
#include "analysis/vote_matrix.h"

namespace {

using analysis::read_votes_csv;
using protocols::Choice;
using testing::HasSubstr;

const std::string header = "observer,session,trial,scene,variant,left,right,chosen,rt_ms\n";

std::string error_of(const std::string& text) {
    const auto table = read_votes_csv(text, "v.csv");
    return table ? "no error" : table.error();
}

TEST(VoteCsv, ReadsTheLongExport) {
    const auto table =
        read_votes_csv("study,observer,session,trial,scene,variant,left,right,chosen,rt_ms,"
                       "onset_utc\r\npilot,O1,2,7,bunny,back,A,B,right,850,2026-01-01T10:00:00Z\r\n"
                       "pilot,O2,1,1,bunny,front,B,A,tie,,\r\n",
                       "v.csv")
            .value();
    EXPECT_EQ(table.study, "pilot");
    EXPECT_EQ(table.factor_names, (std::vector<std::string>{"scene", "variant"}));
    EXPECT_EQ(table.size(), 2u);
    EXPECT_EQ(table.chosen, (std::vector{Choice::Right, Choice::Tie}));
    EXPECT_EQ(table.response_ms, (std::vector{850, -1}));
    EXPECT_EQ(table.trial, (std::vector{7, 1}));
    EXPECT_FALSE(table.simulated);
    EXPECT_TRUE(table.notes.empty());
}

TEST(VoteCsv, RightMeansTheConditionShownRightWon) {
    const auto table = read_votes_csv(header + "O1,1,1,s,,A,B,right,5\n", "v.csv").value();
    const auto matrix = analysis::count_votes(table);
    EXPECT_EQ(matrix.wins(1, 0), 1); // B over A
    EXPECT_EQ(matrix.wins(0, 1), 0);
    EXPECT_EQ(matrix.right_chosen(0, 1), 1);
}

// The program's own export of a study without variants has that column, and nothing in it.
TEST(VoteCsv, AnEmptyColumnIsNoSceneFactor) {
    const auto table = analysis::read_votes_csv("observer,scene,variant,left,right,chosen\n"
                                                "O1,s,,A,B,left\nO2,t,,A,B,left\n",
                                                "v.csv")
                           .value();
    EXPECT_EQ(table.factor_names, std::vector<std::string>{"scene"});
    EXPECT_EQ(table.factor.size(), 1u);
    const auto some = analysis::read_votes_csv("observer,scene,variant,left,right,chosen\n"
                                               "O1,s,,A,B,left\nO2,t,back,A,B,left\n",
                                               "v.csv")
                          .value();
    EXPECT_EQ(some.factors.at(1).names(), (std::vector<std::string>{"", "back"}));
}

TEST(VoteCsv, PassesOverWarmUpsAndSaysHowMany) {
    const auto table =
        read_votes_csv(
            "observer,phase,simulated,left,right,choice,age\n"
            "O1,warmup,1,A,B,left,30\nO1,training,1,A,B,left,30\nO1,main,1,A,B,left,30\n",
            "v.csv")
            .value();
    EXPECT_EQ(table.size(), 1u);
    EXPECT_EQ(table.skipped_not_main, 2);
    EXPECT_TRUE(table.simulated);
    EXPECT_THAT(table.notes, testing::ElementsAre("columns not read: age"));
}

TEST(VoteCsv, ErrorsNameFileLineValueAndRemedy) {
    EXPECT_EQ(error_of(""),
              "v.csv:1: the file is empty, expected a header row with observer, left, "
              "right and chosen");
    EXPECT_EQ(error_of(header), "v.csv:1: no votes below the header, expected one per row");
    EXPECT_THAT(error_of("observer,left,right\n"), HasSubstr("v.csv:1: no column 'chosen'"));
    EXPECT_THAT(error_of("observer,left,right,chosen,left\n"),
                HasSubstr("v.csv:1: column 'left' stands twice"));
    EXPECT_THAT(error_of("observer,left,right,chosen,choice\n"),
                HasSubstr("v.csv:1: both 'chosen' and 'choice'"));
    EXPECT_EQ(error_of(header + "O1,1,1,s,,A,B,left\n"),
              "v.csv:2: 8 fields, expected 9 as in the header");
    EXPECT_EQ(error_of(header + "O1,1,1,s,,A,A,left,5\n"),
              "v.csv:2: left and right are both 'A', expected two different conditions");
    EXPECT_EQ(error_of(header + "O1,1,1,s,,A,B,up,5\n"),
              "v.csv:2: answer 'up', expected left, right or tie");
    EXPECT_EQ(error_of(header + "O1,1,1,s,,A,B,left,fast\n"),
              "v.csv:2: rt_ms is 'fast', expected a whole number, 0 or more");
    EXPECT_EQ(error_of(header + ",1,1,s,,A,B,left,5\n"),
              "v.csv:2: an empty observer, left or right, expected a name");
    EXPECT_THAT(error_of("observer,phase,left,right,chosen\nO1,lunch,A,B,left\n"),
                HasSubstr("v.csv:2: phase 'lunch', expected training, warmup or main"));
    EXPECT_THAT(error_of("study,observer,left,right,chosen\nx,O1,A,B,left\ny,O2,A,B,left\n"),
                HasSubstr("v.csv:3: study 'y' after 'x', expected one study per file"));
}

TEST(VoteCsv, RefusesASecondAnswerToOneQuestionWhicheverSide) {
    const auto text = header + "O1,1,1,s,,A,B,left,5\nO2,1,1,s,,A,B,left,5\nO1,1,2,s,,B,A,left,5\n";
    EXPECT_EQ(error_of(text), "v.csv:4: O1 answered this question already on line 2, expected one "
                              "vote per observer, session, scene and pair");
    EXPECT_EQ(read_votes_csv(text, "v.csv", analysis::Repeats::Allow).value().size(), 3u);
}

} // namespace
