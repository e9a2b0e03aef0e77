#include "experiment/cost/choices.h"
#include "experiment/cost/cost_files.h"
#include "experiment/cost/read_cost.h"
#include "tests/experiment/cost/small_report.h"

#include <nlohmann/json.hpp>

namespace {

using namespace experiment::cost;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

CostReport with_choice() {
    auto report = tests::small_report();
    report.scenes[0].lights[0].choice = choose(report.scenes[0], 0, report.wish);
    report.scenes[0].lights[0].choice->measured = 0.041;
    return report;
}

/// What is said of the report with one place of its text changed; "" when it is read all the same.
std::string complaint(const std::string& there, const std::string& instead) {
    auto damaged = cost_json(with_choice());
    const auto place = damaged.find(there);
    EXPECT_NE(place, std::string::npos) << there;
    damaged.replace(place, there.size(), instead);
    const auto report = parse_cost(damaged, "c.json");
    return report ? "" : report.error();
}

TEST(ReadCost, GivesBackWhatWasWritten) {
    const auto report = with_choice();
    const auto again = parse_cost(cost_json(report), "cost.json");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(*again, report);
}

// Peeled maps of a light, or the mesh of a large scan, take more than 2 GiB.
TEST(ReadCost, GivesBackMoreBytesThanAnIntHolds) {
    auto report = with_choice();
    report.scenes[0].rows[0].bytes_per_light = 3'221'225'472;
    const auto again = parse_cost(cost_json(report), "cost.json");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(*again, report);
}

TEST(ReadCost, SaysWhatIsWrongWithAFile) {
    EXPECT_EQ(parse_cost("{", "c.json").error(),
              "c.json:1: the JSON ends before it is complete; expected a cost.json as it was "
              "written; run `pairlight cost` again, or take the file away");
    EXPECT_THAT(parse_cost("{\"pictures\": []}", "c.json").error(),
                AllOf(StartsWith("c.json:1: there is no form; "), HasSubstr("`pairlight cost`")));
    EXPECT_THAT(parse_cost("{\"form\": 1}", "c.json").error(),
                StartsWith("c.json:1: form is 1, expected 2; "));
    EXPECT_THAT(parse_cost("{\"form\": -0}", "c.json").error(),
                StartsWith("c.json:1: form is 0, expected 2; "));
    EXPECT_THAT(parse_cost("{\"form\": \"2\"}", "c.json").error(),
                StartsWith("c.json:1: form is \"2\", expected a whole number"));
    EXPECT_THAT(complaint("\"row\": 2", "\"row\": 9"),
                HasSubstr("scenes[0].lights[0].choice.row is 9, expected one of the 4 rows"));
    EXPECT_THAT(complaint("\"subject\": \"A ball\"", "\"subject\": 7"),
                HasSubstr("subject is 7, expected a text in quotes"));
    auto json = nlohmann::json::parse(cost_json(with_choice()));
    json["scenes"][0]["rows"][1]["lights"].erase(1);
    EXPECT_THAT(parse_cost(json.dump(2), "c.json").error(), HasSubstr("the errors under 1 lights"));
    auto report = with_choice();
    report.scenes.clear();
    EXPECT_THAT(parse_cost(cost_json(report), "c.json").error(), HasSubstr("there is no scene"));
}

TEST(ReadCost, RefusesNumbersThatNothingMeasures) {
    EXPECT_THAT(complaint("\"bytes_per_vertex\": 100", "\"bytes_per_vertex\": -5"),
                HasSubstr("rows[1].bytes_per_vertex is -5, expected a whole number from 0; "));
    EXPECT_THAT(complaint("\"bytes_per_vertex\": 100", "\"bytes_per_vertex\": 1.7"),
                HasSubstr("bytes_per_vertex is 1.7"));
    EXPECT_THAT(complaint("\"law\": 0.2", "\"law\": -0.5"), HasSubstr("law is -0.5"));
    EXPECT_THAT(complaint("\"law\": 0.2", "\"law\": 1e308"), HasSubstr("law is 1e+308"));
    EXPECT_THAT(complaint("\"lower\": 5", "\"lower\": 9995"), HasSubstr("lower <= median"));
    // every number that a table or a figure shows has the same bounds
    const auto written = cost_json(with_choice());
    for (const std::string key : {"lower", "median", "upper", "clock_ms", "predicted", "measured"})
        for (const auto* number : {"-1", "1e30", "1e308"}) {
            const auto place = written.find("\"" + key + "\": ");
            ASSERT_NE(place, std::string::npos) << key;
            const auto there = written.substr(place, written.find_first_of(",\n", place) - place);
            EXPECT_THAT(
                complaint(there, "\"" + key + "\": " + number),
                AllOf(HasSubstr(key + " is "), HasSubstr("expected a number from 0 to 1e30")))
                << key << ' ' << number;
        }
}

TEST(ReadCost, RefusesWordsThatMeanNothing) {
    EXPECT_THAT(complaint("\"error\": \"law\"", "\"error\": \"bogus\""),
                HasSubstr("wish.error is \"bogus\""));
    EXPECT_THAT(complaint("\"tolerance\"", "\"tolerant\""),
                HasSubstr("neither wish.tolerance nor wish.budget_ms"));
    EXPECT_THAT(complaint("\"law\": \"physical\"", "\"law\": \"moral\""),
                HasSubstr("law is \"moral\", expected paper or physical"));
    EXPECT_THAT(complaint("\"timed_by\": \"processor\"", "\"timed_by\": \"sun\""),
                HasSubstr("timed_by is \"sun\", expected processor or clock"));
}

// A key that stands twice would count once, and of two pictures of one name one would be lost.
TEST(ReadCost, RefusesWhatIsThereTwice) {
    EXPECT_THAT(complaint("\"rounds\": 3", "\"rounds\": 3, \"rounds\": 4"),
                HasSubstr("'rounds' stands twice"));
    EXPECT_THAT(complaint("\"id\": \"left\"", "\"id\": \"back\""),
                HasSubstr("scene \"ball\", variant \"back\", is there twice, expected it once"));
    auto report = with_choice();
    report.scenes.push_back(report.scenes[0]);
    EXPECT_THAT(parse_cost(cost_json(report), "c.json").error(), HasSubstr("is there twice"));
}

// Figures are written under these names.
TEST(ReadCost, RefusesIdsThatLeadOutOfTheFolder) {
    for (const auto* id : {"../../etc/ball", "a/b", "..", "", "ball\\u0000", "a\\nb"})
        EXPECT_THAT(complaint("\"id\": \"ball\"", std::string("\"id\": \"") + id + "\""),
                    HasSubstr("scenes[0].id is \""))
            << id;
    EXPECT_THAT(
        complaint("\"id\": \"left\"", "\"id\": \"x/y\""),
        HasSubstr("scenes[0].lights[1].id is \"x/y\", expected a name that a file may have"));
    EXPECT_EQ(complaint("\"id\": \"ball\"", "\"id\": \"Stanford bunny (1)\""), "");
}

} // namespace
