#include "analysis/formats/vote_files.h"
#include "analysis/vote_matrix.h"

#include <string>

namespace {

using namespace analysis;
using formats::read_vote_file;
using testing::Contains;
using testing::HasSubstr;

std::int64_t wins(const VoteTable& table, const std::string& winner, const std::string& loser) {
    return count_votes(table).wins(static_cast<std::size_t>(table.conditions.find(winner)),
                                   static_cast<std::size_t>(table.conditions.find(loser)));
}

// In the form of the toolbox's own example: two contents of three pictures each.
constexpr const char* script = R"(# Permission to use, copy, modify ...
dataset_name = 'sharpened'
ref_score = 0
ref_videos = [{'content_id': 0, 'content_name': 'Caps', 'path': 'Caps1.png'},
 {'content_id': 1, 'content_name': 'isabe', 'path': 'isabe1.png'}]
dis_videos = [{'asset_id': 0,
  'content_id': 0,
  'os': {('David R.', 1): 1,
         ('Jana', 1): 0.5},
  'path': 'Caps1.png'},
 {'asset_id': 1, 'content_id': 0, 'os': {('David R.', 2): 1}, 'path': 'Caps2.png'},
 {'asset_id': 2, 'content_id': 0, 'os': {('Jana', 0): 1}, 'path': 'x/Caps3.png'},
 {'asset_id': 3, 'content_id': 1, 'os': {('Jana', 4): 0}, 'path': 'isabe1.png'},
 {'asset_id': 4, 'content_id': 1, 'os': {}, 'path': 'isabe2.png'},
 {'asset_id': 5, 'content_id': 1, 'os': {}, 'path': 'isabe3.png'}]
)";

TEST(SurealFile, TheWinnersEntryHoldsTheSubjectAndTheLoser) {
    const auto table = read_vote_file(script, "lukas.py");
    ASSERT_TRUE(table) << table.error();
    EXPECT_EQ(table->size(), 5u);
    EXPECT_EQ(table->observers.names(), (std::vector<std::string>{"David R.", "Jana"}));
    EXPECT_EQ(table->conditions.names(), (std::vector<std::string>{"1", "2", "3"}));
    EXPECT_EQ(table->factor_names, std::vector<std::string>{"content"});
    EXPECT_EQ(table->factors[0].names(), (std::vector<std::string>{"Caps", "isabe"}));
    EXPECT_EQ(wins(*table, "1", "2"), 1);
    EXPECT_EQ(wins(*table, "2", "3"), 1);
    EXPECT_EQ(wins(*table, "3", "1"), 1);
    EXPECT_EQ(wins(*table, "2", "1"), 1); // 0 in the entry of asset 3: asset 4 was chosen
    EXPECT_EQ(count_votes(*table).total_ties(), 1);
    EXPECT_THAT(table->notes, Contains(HasSubstr("which condition was on the left")));
    EXPECT_THAT(table->notes, Contains("conditions are called by their files' names"));
}

TEST(SurealFile, JsonHasItsKeysAsTexts) {
    const std::string text = R"text({"dataset_name": "d", "ref_videos": [], "dis_videos": [
  {"asset_id": 0, "content_id": 7, "os": {"('Ann', 1)": 1, "[\"Bob\", 1]": 1}},
  {"asset_id": 1, "content_id": 7, "os": {"('Cleo', 0)": 1, "('Ann', 0)": 0}}]})text";
    const auto table = read_vote_file(text, "d.json");
    ASSERT_TRUE(table) << table.error();
    EXPECT_EQ(table->size(), 3u);
    EXPECT_EQ(wins(*table, "0", "1"), 2);
    EXPECT_EQ(wins(*table, "1", "0"), 1);
    EXPECT_THAT(table->notes, Contains("conditions are called by their assets' numbers"));
    EXPECT_THAT(table->notes,
                Contains("1 votes stand in the file from both sides: they count once"));
}

std::string error_of(const std::string& assets) {
    const auto table = read_vote_file("{\"dis_videos\": [\n" + assets + "\n]}", "d.json");
    return table ? "no error" : table.error();
}

const std::string other = ",\n{'asset_id': 1, 'content_id': 0, 'os': {}}";

// Of a data set whose first asset, on line 2, has these votes.
std::string error_of_votes(const std::string& os) {
    return error_of("{'asset_id': 0, 'content_id': 0, 'os': {" + os + "}}" + other);
}

TEST(SurealFile, BadVotesAreNamedByTheirLine) {
    EXPECT_EQ(error_of_votes("('A', 1): 1"), "no error");
    EXPECT_EQ(error_of_votes(""), "d.json:1: no votes in any 'os'");
    EXPECT_EQ(error_of_votes("('A', 2): 1"), "d.json:2: asset 2 is not among 'dis_videos'");
    EXPECT_EQ(error_of_votes("('A', 0): 1"), "d.json:2: asset 0 against itself");
    EXPECT_THAT(error_of_votes("\n'A, 1': 1"), HasSubstr("d.json:3: a key of 'os' is no pair"));
    EXPECT_THAT(error_of_votes("('', 1): 1"), HasSubstr("a key of 'os' is no pair"));
    EXPECT_THAT(error_of_votes("('A', 1.5): 1"), HasSubstr("a key of 'os' is no pair"));
    EXPECT_EQ(error_of_votes("('A', 1): 2"),
              "d.json:2: the vote of A on assets 0 and 1: expected 1, 0, or 0.5 for a tie");
    EXPECT_THAT(error_of_votes("('A', 1): NaN"), HasSubstr("d.json:2: 'NaN', expected a value"));
    EXPECT_EQ(error_of_votes("('A', 1): 1,\n('A', 1): 1"),
              "d.json:3: A was asked about assets 0 and 1 before, on line 2: the form holds one "
              "answer");
    EXPECT_THAT(error_of("{'asset_id': 0, 'content_id': 0, 'os': {('A', 1): 1}},\n"
                         "{'asset_id': 1, 'content_id': 0, 'os': {('A', 0): 1}}"),
                HasSubstr("d.json:3: A was asked about assets 1 and 0 before, on line 2"));
}

TEST(SurealFile, BadAssetsAreNamedByTheirLine) {
    EXPECT_THAT(error_of("{'asset_id': 0, 'content_id': 0, 'os': {('A', 1): 1}},\n"
                         "{'asset_id': 1, 'content_id': 3, 'os': {}}"),
                HasSubstr("d.json:2: asset 0 is of content 0, asset 1 of 3"));
    EXPECT_THAT(error_of("{'asset_id': 0, 'content_id': 0, 'os': [3, 4, 5]}"),
                HasSubstr("asset 0 has no map 'os' of (subject, asset): 1; ratings are no votes"));
    EXPECT_EQ(error_of("{'asset_id': 0, 'content_id': 0, 'os': {}}" + other + other),
              "d.json:4: asset 1 stands twice");
    EXPECT_EQ(error_of("{'asset_id': -1, 'content_id': 0, 'os': {}}"),
              "d.json:2: expected whole numbers as 'asset_id' and 'content_id'");
    EXPECT_THAT(error_of("[1, 2]"), HasSubstr("d.json:2: expected whole numbers"));
    EXPECT_EQ(error_of("{'asset_id': 0, 'content_id': 0, 'os': {},\n'os': {}}"),
              "d.json:3: 'os' stands twice, expected once");
    EXPECT_EQ(read_vote_file("[]", "d.json", formats::VoteFormat::Sureal).error(),
              "d.json:1: '[', expected a name and =");
    EXPECT_EQ(read_vote_file("{}", "d.json", formats::VoteFormat::Sureal).error(),
              "d.json:1: no list 'dis_videos', expected a data set of sureal");
}

} // namespace
