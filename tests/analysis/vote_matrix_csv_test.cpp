#include "analysis/vote_csv.h"
#include "analysis/vote_matrix_csv.h"

#include <sstream>

namespace {

constexpr const char* two_votes = "observer,session,scene,left,right,chosen,simulated\n"
                                  "O1,1,a,X,Y,left,0\n"
                                  "O1,1,b,Y,X,right,{}\n";

analysis::VoteTable table(const std::string& simulated) {
    std::string text = two_votes;
    text.replace(text.find("{}"), 2, simulated);
    return analysis::read_votes_csv(text, "votes.csv").value();
}

// X beats Y from the left and from the right: row 1 of the pooled scope counts both.
TEST(VoteMatricesCsv, HasTheWinnerFirst) {
    const auto csv = analysis::vote_matrices_csv(table("0"));
    EXPECT_THAT(csv, testing::StartsWith("scope,observer,session,scene,winner,loser,votes\n"
                                         "all,,,,X,Y,2\nall,,,,Y,X,0\n"));
    EXPECT_THAT(analysis::scores_csv(table("0")),
                testing::StartsWith("scope,observer,session,scene,method,votes,max_votes,share\n"
                                    "all,,,,X,2,2,1\nall,,,,Y,0,2,0\n"));
}

TEST(VoteMatricesCsv, MarksSimulatedVotesInEveryRow) {
    for (const auto& csv :
         {analysis::vote_matrices_csv(table("1")), analysis::scores_csv(table("1"))}) {
        std::istringstream lines(csv);
        std::string line;
        std::getline(lines, line);
        EXPECT_THAT(line, testing::EndsWith(",simulated"));
        int rows = 0;
        for (; std::getline(lines, line); ++rows)
            EXPECT_THAT(line, testing::EndsWith(",1"));
        EXPECT_GT(rows, 0);
    }
}

} // namespace
