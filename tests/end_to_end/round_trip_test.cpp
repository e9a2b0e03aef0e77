// Every form that `export` writes, read again by `analyze`: the same findings, or a clear refusal.
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"

#include <nlohmann/json.hpp>

namespace {

using namespace tests;
using nlohmann::json;
using testing::HasSubstr;

class RoundTrip : public testing::Test {
  protected:
    void SetUp() override {
        write_small_study(study.path());
        ASSERT_EQ(pairlight({"simulate", study.path().string(), "--observers", "4"}).status, 0);
    }

    std::string exported(const std::string& form) {
        const auto file = (study / (form + ".csv")).string();
        const auto outcome =
            pairlight({"export", study.path().string(), "--format", form, "--csv", file});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return file;
    }

    // The conditions in the study's order, which a table cannot know.
    json findings(const std::string& source) {
        const auto out = (study / "findings.json").string();
        const auto outcome = pairlight({"analyze", source, "--order", "first,second,third",
                                        "--replicates", "100", "--json", out, "--quiet"});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return json::parse(read_file(out));
    }

    TemporaryFolder study;
};

// What a form cannot carry is left out before comparing; the rest must be equal to the last bit.
void expect_same(json before, json after, const std::vector<std::string>& not_carried) {
    for (auto* document : {&before, &after})
        for (const auto& part : not_carried)
            document->erase(part);
    EXPECT_GT(before.size(), 5u);
    EXPECT_EQ(json::diff(before, after), json::array());
}

TEST_F(RoundTrip, TheLongTableCarriesEverything) {
    expect_same(findings(study.path().string()), findings(exported("long")),
                {"source", "source_digest", "notes"});
}

TEST_F(RoundTrip, TheOtherFormsCarryAllButSidesOrderAndTimes) {
    const auto before = findings(study.path().string());
    for (const auto* form : {"matrices", "pwcmp", "pairs", "paired-comparison", "sureal"}) {
        const auto after = findings(exported(form));
        for (const auto* part : {"anova", "paper_score", "ranking", "friedman_observer_means"}) {
            ASSERT_TRUE(before.contains(part)) << part;
            EXPECT_EQ(json::diff(before[part], after[part]), json::array()) << form << part;
        }
        EXPECT_EQ(before["design"]["votes"], after["design"]["votes"]);
        EXPECT_TRUE(after["design"]["simulated"].get<bool>()) << form;
    }
}

TEST_F(RoundTrip, ScoresAreNoVotesAndSaySo) {
    const auto outcome = pairlight({"analyze", exported("scores")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("scores do not say who was chosen over whom"));
}

} // namespace
