#include "analysis/formats/vote_files.h"
#include "analysis/utf8.h"
#include "analysis/vote_matrix.h"
#include "tests/analysis/golden.h"

#include <fmt/format.h>

namespace {

using namespace analysis;
using formats::read_vote_file;
using formats::VoteFormat;
using protocols::Choice;
using testing::Contains;
using testing::HasSubstr;

std::string error_of(const std::string& text, VoteFormat format = VoteFormat::Detect) {
    const auto table = read_vote_file(text, "v.csv", format);
    return table ? "no error" : table.error();
}

// Wins of a named condition over another, whatever their order in the table.
std::int64_t wins(const VoteTable& table, const std::string& winner, const std::string& loser) {
    return count_votes(table).wins(static_cast<std::size_t>(table.conditions.find(winner)),
                                   static_cast<std::size_t>(table.conditions.find(loser)));
}

TEST(VoteFiles, OneMeansThatTheFirstOfTwoWasChosen) {
    const auto table = read_vote_file("observer,session_id,scene,condition_A,condition_B,"
                                      "is_A_selected,criterion\nM01,1,window,x,y,1,perceptual\n"
                                      "M01,1,night,y,x,0,perceptual\nM02,1,window,x,y,0.5,other\n",
                                      "v.csv")
                           .value();
    EXPECT_EQ(wins(table, "x", "y"), 2);
    EXPECT_EQ(wins(table, "y", "x"), 0);
    EXPECT_EQ(table.chosen[2], Choice::Tie);
    EXPECT_EQ(table.factor_names, std::vector<std::string>{"scene"});
    EXPECT_THAT(table.notes, Contains(HasSubstr("which condition was on the left")));
    EXPECT_THAT(table.notes, Contains("columns not read: criterion"));
}

TEST(VoteFiles, TheOlderFormSaysOneOrTwo) {
    const auto table = read_vote_file("observer,session,scene,condition_A,condition_B,selection\n"
                                      "O,1,s,x,y,2\n",
                                      "v.csv")
                           .value();
    EXPECT_EQ(wins(table, "y", "x"), 1);
    EXPECT_THAT(error_of("observer,condition_A,condition_B,selection\nO,x,y,0\n"),
                HasSubstr("v.csv:2: answer '0', expected 1, 2 or 0.5 for a tie"));
}

TEST(VoteFiles, TheChosenMayBeNamed) {
    const auto table = read_vote_file("observer,session,left,right,selected,time_spent\n"
                                      "O,1,x.png,y.png,y.png,1.2345\n",
                                      "v.csv")
                           .value();
    EXPECT_EQ(wins(table, "y.png", "x.png"), 1);
    EXPECT_EQ(table.response_ms[0], 1235); // 1234.5, away from zero
    EXPECT_THAT(error_of("observer,left,right,selected\nO,x,y,z\n"),
                HasSubstr("v.csv:2: answer 'z', expected x or y"));
}

// The columns of a session's own rows, apart by tabs.
TEST(VoteFiles, RowsOfASessionAreReadByTheirCountedVotes) {
    const std::string header = "row_id\tparticipant_id\tsession_index\tphase\tcounted\ttrial_shown"
                               "\tscene\tvariant\tmethod_a\tmethod_b\tleft_method\tright_method\t"
                               "response\tresponse_time\n";
    const auto table =
        read_vote_file(header + "1\tP1\t1\ttraining\t0\t1\ts\tv\tx\ty\ty\tx\tleft\t1\n"
                                "2\tP1\t1\tmain\t1\t2\ts\tv\tx\ty\ty\tx\tright\t0.8125\n"
                                "3\tP1\t1\tmain\t0\t3\ts\tv\tx\tz\tx\tz\tleft\t0.9\n"
                                "4\tP1\t1\tmain\t1\t4\ts\tv\ty\tz\ty\tz\tnone\tn/a\n"
                                "5\tP1\t1\tmain\t1\t5\ts\tv\tx\tz\tx\tz\tnot_sure\t2\n",
                       "v.tsv")
            .value();
    EXPECT_EQ(table.size(), 2u);
    EXPECT_EQ(wins(table, "x", "y"), 1);
    EXPECT_EQ(table.chosen[1], Choice::Tie);
    EXPECT_EQ(table.response_ms[0], 813);
    EXPECT_EQ(table.skipped_not_main, 1);
    EXPECT_EQ(table.factor_names, (std::vector<std::string>{"scene", "variant"}));
    EXPECT_THAT(table.notes, Contains("1 rows marked as not counted were passed over"));
    EXPECT_THAT(table.notes, Contains("1 questions without an answer were passed over"));
    EXPECT_THAT(table.notes, Contains("1 answers were \"not sure\": they count as ties"));
}

TEST(VoteFiles, AMatrixIsRowOverColumn) {
    const auto table =
        read_vote_file("item,A1,A2,A3\nA1,0,3,2\nA2,12,0,11\nA3,13,4,0\n", "m.csv").value();
    EXPECT_EQ(wins(table, "A1", "A2"), 3);
    EXPECT_EQ(wins(table, "A2", "A1"), 12);
    EXPECT_EQ(wins(table, "A3", "A2"), 4);
    EXPECT_EQ(table.size(), 45u);
    EXPECT_THAT(table.notes, Contains(HasSubstr("does not name observers")));
    const auto bare = read_vote_file("0,3,2\n12,0,11\n13,4,0\n", "m.csv").value();
    EXPECT_EQ(wins(bare, "1", "2"), 3);
    EXPECT_THAT(error_of("item,A,B\nA,0,3\nC,1,0\n"),
                HasSubstr("v.csv:3: row 'C', expected 'B' as in the header"));
    EXPECT_THAT(error_of("item,A,B\nA,0,3\nB,1,2\n"),
                HasSubstr("v.csv:3: 'B' against itself, expected two conditions"));
    EXPECT_THAT(error_of("item,A,B\nA,0,x\nB,1,0\n"),
                HasSubstr("v.csv:2: 'x', expected a count: a whole number, 0 or more"));
    EXPECT_THAT(error_of("0,3,2\n1,0,4\n", VoteFormat::Matrix), HasSubstr("expected a square"));
}

// D(i, j) is i over j, and the rows run down the columns: 0 2 / 1 0 is written 0, 1, 2, 0.
TEST(VoteFiles, ObserverMatricesRunDownTheColumns) {
    const auto table =
        read_vote_file("0,1,2,0\n0,0,3,0\n0,4,0,0\n", "d.csv", VoteFormat::ObserverMatrices)
            .value();
    EXPECT_EQ(table.observers.size(), 3u);
    EXPECT_EQ(wins(table, "1", "2"), 5);
    EXPECT_EQ(wins(table, "2", "1"), 5);
    EXPECT_THAT(error_of("0,1,2,0\n"), HasSubstr("no error"));
    EXPECT_THAT(error_of("0,1,2,0\n0,1,2,0\n0,0,0,0\n0,0,1,0\n"), HasSubstr("say --format"));
}

TEST(VoteFiles, PairsAreWinnerAndLoser) {
    const auto table = read_vote_file("1,0\n1,0\n0,2\n", "c.csv").value();
    EXPECT_EQ(wins(table, "1", "0"), 2);
    EXPECT_EQ(wins(table, "0", "2"), 1);
    const auto named = read_vote_file("winner,loser,votes\nx,y,7\n", "c.csv").value();
    EXPECT_EQ(wins(named, "x", "y"), 7);
    const auto counts =
        read_vote_file("player1,player2,win1,win2,ties\nx,y,3,5,2\n", "c.csv").value();
    EXPECT_EQ(wins(counts, "x", "y"), 3);
    EXPECT_EQ(wins(counts, "y", "x"), 5);
    EXPECT_EQ(count_votes(counts).total_ties(), 2);
    EXPECT_THAT(error_of("winner,loser,votes\nx,x,1\n"), HasSubstr("'x' against itself"));
    EXPECT_THAT(error_of("winner,loser,votes\nx,y,99999999999\n"), HasSubstr("more than 20000000"));
}

TEST(VoteFiles, WideRowsHaveAColumnPerPair) {
    const auto table =
        read_vote_file("subject,1:2,1:3,2:3\na,1,-1,0\nb,-1,NA,1\n", "w.csv").value();
    EXPECT_EQ(table.observers.size(), 2u);
    EXPECT_EQ(wins(table, "1", "2"), 1);
    EXPECT_EQ(wins(table, "2", "1"), 1);
    EXPECT_EQ(wins(table, "3", "1"), 1);
    EXPECT_EQ(count_votes(table).total_ties(), 1);
    EXPECT_THAT(table.notes, Contains("1 cells are empty: not asked"));
    const auto old = read_vote_file("V12,V13,V23\n1,1,-1\n-1,1,1\n", "w.csv").value();
    EXPECT_EQ(wins(old, "1", "3"), 2);
    EXPECT_THAT(error_of("subject,x:y\na,1\nb,0\n"), HasSubstr("say --format wide"));
    const auto wide = read_vote_file("participant,session,scene,x:y\na,1,s,1\nb,1,s,0\n", "w.csv",
                                     VoteFormat::Wide)
                          .value();
    EXPECT_EQ(wins(wide, "x", "y"), 1);
    EXPECT_EQ(wins(wide, "y", "x"), 1);
    EXPECT_EQ(wide.factor_names, std::vector<std::string>{"scene"});
}

TEST(VoteFiles, AColumnSaidTwiceIsRefused) {
    const auto wide = [](const std::string& text) {
        const auto table = read_vote_file(text, "w.csv", VoteFormat::PairedComparison);
        return table ? "no error" : table.error();
    };
    EXPECT_EQ(wide("observer,x:y,x:y\nP1,1,1\n"),
              "w.csv:1: column 'x:y' says the same as 'x:y' before it, expected each pair and each "
              "name once");
    EXPECT_THAT(wide("1:2,V12\n1,1\n"), HasSubstr("'V12' says the same as '1:2'"));
    EXPECT_THAT(wide("observer,subject,x:y\nP1,P2,1\n"), HasSubstr("'subject' says the same"));
    EXPECT_THAT(wide("light,light,x:y\na,b,1\n"), HasSubstr("'light' says the same"));
    EXPECT_EQ(wide("x:y,y:x\n1,1\n"), "no error"); // asked both ways round
}

// The golden votes in four of these forms give one matrix.
TEST(VoteFiles, EveryFormOfTheSameVotesGivesTheSameMatrix) {
    const auto golden = golden_votes();
    std::string pairs = "observer,winner,loser\n", toolbox = "observer,session_id,scene,"
                                                             "condition_A,condition_B,"
                                                             "is_A_selected\n";
    for (std::size_t vote = 0; vote < golden.size(); ++vote) {
        const auto left = golden.conditions.name(golden.left[vote]);
        const auto right = golden.conditions.name(golden.right[vote]);
        const bool first = golden.chosen[vote] == Choice::Left;
        pairs += fmt::format("{},{},{}\n", golden.observers.name(golden.observer[vote]),
                             first ? left : right, first ? right : left);
        toolbox +=
            fmt::format("{},{},{}-{},{},{},{}\n", golden.observers.name(golden.observer[vote]),
                        golden.sessions.name(golden.session[vote]),
                        golden.factors[0].name(golden.factor[0][vote]),
                        golden.factors[1].name(golden.factor[1][vote]), left, right, first ? 1 : 0);
    }
    std::string matrix = "over";
    for (const auto& name : golden.conditions.names())
        matrix += "," + name;
    for (const auto& row : golden.conditions.names()) {
        matrix += "\n" + row;
        for (const auto& column : golden.conditions.names())
            matrix += fmt::format(",{}", row == column ? 0 : wins(golden, row, column));
    }
    for (const auto& text : {pairs, toolbox, matrix + "\n"}) {
        const auto table = read_vote_file(text, "v.csv").value();
        EXPECT_EQ(table.size(), golden.size());
        for (const auto& row : golden.conditions.names())
            for (const auto& column : golden.conditions.names())
                if (row != column) {
                    EXPECT_EQ(wins(table, row, column), wins(golden, row, column));
                }
    }
}

TEST(VoteFiles, OneConditionOrNoVoteIsRefused) {
    EXPECT_THAT(error_of("over,A\nA,0\n", VoteFormat::Matrix), HasSubstr("v.csv:1: no votes"));
    EXPECT_THAT(error_of("observer,left,right,chosen\nO,A,A,left\n"),
                HasSubstr("v.csv:2: left and right are both 'A'"));
    EXPECT_THAT(error_of(""), HasSubstr("v.csv:1:"));
    EXPECT_THAT(error_of("winner,loser\n"), HasSubstr("v.csv:1: no votes"));
}

TEST(VoteFiles, NamesThatDifferOnlyInBlanksAreRefused) {
    const std::string header = "observer,session,left,right,chosen\n";
    EXPECT_EQ(error_of(header + "O,1,a,b,left\nP,1, b,a,left\n"),
              "v.csv: conditions 'b' and ' b' differ only in blanks around them, expected one "
              "spelling");
    EXPECT_EQ(error_of(header + "O,1,a,b,left\nO ,1,b,a,left\n"),
              "v.csv: observers 'O' and 'O ' differ only in blanks around them, expected one "
              "spelling");
    EXPECT_EQ(error_of(header + std::string("O,1,a\0,b,left\n", 14)),
              "v.csv:2: a zero byte; save the file as text");
}

TEST(VoteFiles, TextThatIsNoUtf8IsNamedByItsLine) {
    EXPECT_EQ(error_of("observer,left,right,chosen\nO,caf\xE9,y,left\n"),
              "v.csv:2: a byte that is no UTF-8; save the file as UTF-8");
    EXPECT_FALSE(first_line_not_utf8("caf\u00e9, \u65e5\u672c, \U0001F600"));
    EXPECT_TRUE(first_line_not_utf8("\xC0\x80"));     // overlong
    EXPECT_TRUE(first_line_not_utf8("\xED\xA0\x80")); // a surrogate
    EXPECT_TRUE(first_line_not_utf8("\xF4\x90\x80\x80"));
    EXPECT_EQ(first_line_not_utf8("a\nb\n\xE2\x82"), 3); // cut short
}

} // namespace
