// What is exported is read back as the same votes.  The long table's own trip is tested where it is
// written, and the whole way through the program in tests/end_to_end.
#include "analysis/formats/sureal_writer.h"
#include "analysis/formats/vote_files.h"
#include "analysis/formats/vote_writers.h"
#include "analysis/vote_matrix.h"
#include "analysis/vote_matrix_csv.h"

#include <string>

namespace {

using namespace analysis;
using formats::read_vote_file;
using protocols::Choice;
using testing::Contains;
using testing::HasSubstr;

// Names that a table must quote; ties; two sessions; an observer who missed one.
VoteTable awkward_votes() {
    const std::vector<std::string> names{"plain", "with, comma", "say \"so\"", "two\nlines"};
    auto table = empty_vote_table({"model", "light"});
    int vote = 0;
    for (const auto* observer : {"P1", "P2", "P10"})
        for (const auto* session : {"1", "2"})
            for (const auto* model : {"bunny", "dragon"})
                for (std::size_t i = 0; i < names.size(); ++i)
                    for (std::size_t j = i + 1; j < names.size(); ++j) {
                        ++vote;
                        if (std::string(observer) == "P2" && *session == '2')
                            continue;
                        const bool swapped = vote % 2 == 0;
                        append_vote(table, {.observer = observer,
                                            .session = session,
                                            .trial = vote,
                                            .scene = {model, "back, low"},
                                            .left = names[swapped ? j : i],
                                            .right = names[swapped ? i : j],
                                            .chosen = vote % 7 == 0   ? Choice::Tie
                                                      : vote % 3 == 0 ? Choice::Right
                                                                      : Choice::Left});
                    }
    return table;
}

struct NamedCount {
    std::string scope, observer, session;
    std::vector<std::string> scene;
    std::string winner, loser;
    std::int64_t wins, ties;

    auto operator<=>(const NamedCount&) const = default;
};

// Every count of every scope, by names: codes may come in another order.
std::vector<NamedCount> counts_of(const VoteTable& table) {
    std::vector<NamedCount> counts;
    for (const auto& scope : usual_scopes(table))
        for (const auto& cell : count_votes(table, scope))
            for (std::size_t i = 0; i < table.conditions.size(); ++i)
                for (std::size_t j = 0; j < table.conditions.size(); ++j)
                    if (i != j)
                        counts.push_back({cell.scope, cell.observer, cell.session, cell.scene,
                                          table.conditions.name(i), table.conditions.name(j),
                                          cell.matrix.wins(i, j), cell.matrix.ties(i, j)});
    std::sort(counts.begin(), counts.end());
    return counts;
}

TEST(RoundTrip, MatricesGiveBackEveryCountOfEveryScope) {
    for (const bool simulated : {false, true}) {
        auto votes = awkward_votes();
        votes.simulated = simulated;
        const auto back = read_vote_file(vote_matrices_csv(votes), "m.csv");
        ASSERT_TRUE(back) << back.error();
        EXPECT_EQ(back->size(), votes.size());
        EXPECT_EQ(back->simulated, simulated);
        EXPECT_EQ(back->factor_names, votes.factor_names);
        EXPECT_GT(count_votes(*back).total_ties(), 0);
        EXPECT_EQ(counts_of(*back), counts_of(votes));
        // What a matrix cannot carry: sides and the order of trials.
        EXPECT_THAT(back->notes,
                    Contains(HasSubstr("does not say which condition was on the left")));
        EXPECT_THAT(back->notes,
                    Contains(HasSubstr("matrices of scope 'observer*session*model*light'")));
    }
}

TEST(RoundTrip, MatricesWithoutScenesOrTiesToo) {
    auto votes = empty_vote_table({});
    append_vote(votes, {.observer = "A", .session = "1", .left = "x", .right = "y"});
    append_vote(votes, {.observer = "B", .session = "1", .left = "y", .right = "x"});
    const auto back = read_vote_file(vote_matrices_csv(votes), "m.csv");
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(counts_of(*back), counts_of(votes));
}

TEST(RoundTrip, OneScopeOfTheMatricesCanBeReadAlone) {
    const auto all = read_vote_file("scope,observer,session,scene,winner,loser,votes,ties\n"
                                    "all,,,,x,y,5,1\nall,,,,y,x,2,1\n",
                                    "m.csv");
    ASSERT_TRUE(all) << all.error();
    EXPECT_EQ(all->size(), 8u);
    EXPECT_THAT(all->notes, Contains(HasSubstr("does not name observers")));
}

TEST(RoundTrip, MatricesThatContradictThemselvesAreRefused) {
    const auto error_of = [](const std::string& rows) {
        const auto table =
            read_vote_file("scope,scene,light,winner,loser,votes,ties\n" + rows, "m.csv");
        return table ? "no error" : table.error();
    };
    EXPECT_EQ(error_of("all,,,x,y,5,1\nall,,,y,x,2,2\n"),
              "m.csv:3: 2 ties of 'y' and 'x', the row the other way round has 1");
    EXPECT_EQ(error_of("scene,a,,x,y,5,1\nlight,,b,y,x,2,1\n"),
              "m.csv:1: scopes 'scene' and 'light' may say the same votes twice; leave the rows of "
              "one");
}

// As other programs read them.  None says which side a condition was on, and the findings know it.
TEST(RoundTrip, FormsOfOtherProgramsGiveBackEveryCountOfEveryScope) {
    for (const bool simulated : {false, true}) {
        auto votes = awkward_votes();
        votes.simulated = simulated;
        for (const auto& text : {formats::pwcmp_csv(votes), formats::pair_counts_csv(votes),
                                 formats::paired_comparison_csv(votes).value()}) {
            const auto header = text.substr(0, text.find('\n'));
            const auto back = read_vote_file(text, "v.csv");
            ASSERT_TRUE(back) << header << back.error();
            EXPECT_EQ(back->size(), votes.size()) << header;
            EXPECT_EQ(back->simulated, simulated) << header;
            EXPECT_EQ(back->factor_names, votes.factor_names) << header;
            EXPECT_EQ(counts_of(*back), counts_of(votes)) << header;
            EXPECT_THAT(back->notes, Contains(HasSubstr("which condition was on the left")))
                << header;
        }
    }
}

TEST(RoundTrip, PairsOfAPsychotoolsTableComeInItsOrder) {
    auto votes = empty_vote_table({});
    append_vote(votes, {.observer = "O", .session = "1", .left = "a", .right = "b"});
    append_vote(votes, {.observer = "O", .session = "1", .left = "c", .right = "a"});
    EXPECT_EQ(formats::paired_comparison_csv(votes).value(),
              "observer,session,a:b,a:c,b:c\nO,1,1,-1,NA\n");
    append_vote(votes, {.observer = "O", .session = "1", .left = "b", .right = "a"});
    EXPECT_EQ(formats::paired_comparison_csv(votes).error(),
              "O compared a and b 2 times in session 1: this form holds one answer; export pairs "
              "instead");
    auto colon = empty_vote_table({});
    append_vote(colon, {.observer = "O", .session = "1", .left = "a:1", .right = "b"});
    EXPECT_THAT(formats::paired_comparison_csv(colon).error(), HasSubstr("'a:1' has a colon"));
}

// The form knows no sessions: each observer's first is left.
VoteTable one_session(const VoteTable& all) {
    auto table = empty_vote_table(all.factor_names);
    for (std::size_t vote = 0; vote < all.size(); ++vote)
        if (all.sessions.name(all.session[vote]) == "1")
            append_vote(table, {.observer = all.observers.name(all.observer[vote]),
                                .session = "1",
                                .scene = {all.factors[0].name(all.factor[0][vote]),
                                          all.factors[1].name(all.factor[1][vote])},
                                .left = all.conditions.name(all.left[vote]),
                                .right = all.conditions.name(all.right[vote]),
                                .chosen = all.chosen[vote]});
    return table;
}

TEST(RoundTrip, ADataSetOfSurealGivesBackEveryCountAndEveryName) {
    for (const bool simulated : {false, true}) {
        auto votes = one_session(awkward_votes());
        votes.simulated = simulated;
        const auto script = formats::sureal_script(votes).value();
        const auto back = read_vote_file(script, "v.py");
        ASSERT_TRUE(back) << back.error() << script;
        EXPECT_EQ(back->size(), votes.size());
        EXPECT_EQ(back->simulated, simulated);
        EXPECT_EQ(back->factor_names, votes.factor_names);
        EXPECT_GT(count_votes(*back).total_ties(), 0);
        EXPECT_EQ(counts_of(*back), counts_of(votes));
        EXPECT_THAT(back->notes, Contains(HasSubstr("which condition was on the left")));
        EXPECT_THAT(back->notes, Contains("conditions are called as their entries say"));
    }
}

// What sureal's own reader wants: numbers from 0 without gaps, keys of a text and a number, and no
// entry of a loser.  Conditions that begin as their content does keep their names.
TEST(RoundTrip, ADataSetOfSurealIsWrittenAsItsReaderWantsIt) {
    auto votes = empty_vote_table({"scene"});
    votes.study = "it's";
    votes.simulated = true;
    append_vote(votes,
                {.observer = "A", .session = "1", .scene = {"a"}, .left = "ab", .right = "ac"});
    append_vote(votes, {.observer = "B",
                        .session = "1",
                        .scene = {"a"},
                        .left = "ab",
                        .right = "ac",
                        .chosen = Choice::Tie});
    const auto script = formats::sureal_script(votes).value();
    EXPECT_EQ(script, R"(dataset_name = 'it\'s'
simulated = True

ref_videos = [
 {'content_id': 0, 'content_name': 'a', 'path': 'a', 'scene': {'scene': 'a'}},
]

dis_videos = [
 {'asset_id': 0, 'content_id': 0, 'condition': 'ab', 'path': 'a/ab.png',
  'os': {('A', 1): 1, ('B', 1): 0.5}},
 {'asset_id': 1, 'content_id': 0, 'condition': 'ac', 'path': 'a/ac.png',
  'os': {('B', 0): 0.5}},
]
)");
    EXPECT_EQ(read_vote_file(script, "v.py").value().conditions.names(),
              (std::vector<std::string>{"ab", "ac"}));
}

TEST(RoundTrip, WhatADataSetOfSurealCannotHoldIsRefused) {
    EXPECT_EQ(formats::sureal_script(awkward_votes()).error(),
              "P1 compared plain and with, comma of bunny/back, low 2 times: this form holds one "
              "answer of an observer; export pairs instead");
    EXPECT_THAT(formats::sureal_script(empty_vote_table({})).error(), HasSubstr("no votes"));
    auto flat = empty_vote_table({});
    append_vote(flat, {.observer = "A", .session = "1", .left = "x", .right = "y"});
    const auto back = read_vote_file(formats::sureal_script(flat).value(), "v.py").value();
    EXPECT_EQ(counts_of(back), counts_of(flat)); // no scene, and none is made up
}

// Sums over opponents: nothing can give back who was chosen over whom.
TEST(RoundTrip, ScoresAreRefusedAsVotes) {
    EXPECT_EQ(read_vote_file(scores_csv(awkward_votes()), "s.csv").error(),
              "s.csv:1: scores do not say who was chosen over whom; export the votes with --format "
              "long or matrices");
}

} // namespace
